// SPDX-License-Identifier: MIT
// Accounts of what is still to be sent: of elements in short fluxes, of faces to the unit.
#include "lib/transport/unshot.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/lib/scenes.h"
#include "tests/lib/sources.h"

namespace fixrad::host {
namespace {

struct Variant {
  const char* name;
  Model (*model)();
  bool overshoot;
};

Model shut_room() {
  return random_closed_room(3);
}
Model open_room() {
  return random_open_room(5);
}

class Accounts : public testing::TestWithParam<Variant> {
 protected:
  SolveOptions options() const {
    SolveOptions options;
    options.elements = 160;
    options.settings = lune_settings(16, fraction(1, 1000));
    options.settings.overshoot = GetParam().overshoot;
    return options;
  }
};

// Unshot flux by the definition, emission that is still to come included: what leaves in all, less what was
// sent. Of the elements, one by one; needs that no face shoots yet.
UnshotSum unshot_by_element(const State& state, int c) {
  UnshotSum sum = {0, 0};
  for (std::uint16_t e = 0; e < state.scene.element_count; ++e) {
    const Element element = flash_read(state.scene.elements, e);
    const fixrad::Material material = flash_read(state.scene.materials, element.material);
    const std::int64_t emission =
        e < state.next_emitter ? 0 : emitted_flux(state.scene, material, element.area, c).raw;
    const std::int64_t flux =
        emission + reflected_flux(state, e, c).raw - std::int64_t{sent_flux(state, e, c)};
    sum.magnitude += static_cast<std::uint64_t>(std::abs(flux));
    sum.balance += flux;
  }
  return sum;
}

UnshotSum unshot_by_source(const State& state, SourceKind kind, int c) {
  UnshotSum sum = {0, 0};
  for (const EyeSource& source : sources_of(state.scene, kind)) {
    Flux unshot[kMaxChannels];
    unshot_of(state, source, unshot);
    sum.magnitude += magnitude(unshot[c].raw);
    sum.balance += unshot[c].raw;
  }
  return sum;
}

void expect_equal(const UnshotSum& a, const UnshotSum& b) {
  EXPECT_EQ(a.magnitude, b.magnitude);
  EXPECT_EQ(a.balance, b.balance);
}

// The same equation holds whoever keeps the accounts.
TEST_P(Accounts, LedgerBalancesAfterEveryShotOfEveryKind) {
  Solution solution(GetParam().model(), options());
  ShotWatch watch(solution);
  SeenShot seen = {};
  int shots[3] = {};
  ASSERT_EQ(solution.imbalance(), 0);
  while (watch.next(seen) == Status::ok) {
    ASSERT_EQ(solution.imbalance(), 0) << "shot " << solution.state().shots;
    ++shots[static_cast<std::size_t>(seen.shot.source.kind)];
  }
  EXPECT_EQ(solution.imbalance(), 0);
  for (const int of_kind : shots) {
    EXPECT_GT(of_kind, 0);
  }
}

TEST_P(Accounts, SumsAreThoseOfTheSources) {
  Solution solution(GetParam().model(), options());
  const State& state = solution.state();
  do {
    for (int c = 0; c < state.scene.channels; ++c) {
      const UnshotSum sum = sum_unshot(state, c);
      ASSERT_GE(sum.magnitude, static_cast<std::uint64_t>(std::abs(sum.balance)));
      if (state.sweep.kind != SourceKind::face) {
        expect_equal(sum, unshot_by_element(state, c));
      } else {
        expect_equal(sum, unshot_by_source(state, SourceKind::face, c));
      }
    }
    ASSERT_FALSE(HasFailure()) << "shot " << state.shots;
  } while (shoot(solution.state()) == Status::ok);
}

TEST_P(Accounts, ToStartWithHoldAllEmission) {
  const Solution solution(GetParam().model(), options());
  const State& state = solution.state();
  for (int c = 0; c < state.scene.channels; ++c) {
    EXPECT_EQ(sum_unshot(state, c).balance, state.emitted[c]);
    EXPECT_EQ(sum_unshot(state, c).magnitude, static_cast<std::uint64_t>(state.emitted[c]));
  }
}

// At any time after the emission: each face holds what its elements held, to the unit.
TEST_P(Accounts, GroupedByFaceHoldTheSame) {
  for (const int shots : {1, 10, 30}) {
    Solution solution(GetParam().model(), options());
    State& state = solution.state();
    while (unshot_by_source(state, SourceKind::element, 0).balance != sum_unshot(state, 0).balance) {
      ASSERT_EQ(solution.run(1), Status::ok) << "emission is still to come";
    }
    ASSERT_EQ(solution.run(shots), Status::ok);
    ASSERT_NE(state.sweep.kind, SourceKind::face) << "too late to group";
    const std::vector<EyeSource> faces = sources_of(state.scene, SourceKind::face);
    std::vector<std::uint64_t> before;
    std::vector<Ledger> ledgers;
    for (const EyeSource& face : faces) {
      before.push_back(unshot_flux(state, face));
    }
    for (int c = 0; c < state.scene.channels; ++c) {
      ledgers.push_back(ledger(state, c));
    }
    group_by_face(state);
    ASSERT_EQ(state.sweep.kind, SourceKind::face);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      EXPECT_EQ(unshot_flux(state, faces[f]), before[f]) << "face " << f;
    }
    for (int c = 0; c < state.scene.channels; ++c) {
      EXPECT_EQ(ledger(state, c).unshot, ledgers[static_cast<std::size_t>(c)].unshot);
      EXPECT_EQ(ledger(state, c).imbalance(), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scene, Accounts,
                         testing::Values(Variant{"Cornell", cornell, false},
                                         Variant{"CornellOvershooting", cornell, true},
                                         Variant{"ShutRoom", shut_room, false},
                                         Variant{"OpenRoom", open_room, false},
                                         Variant{"OpenRoomOvershooting", open_room, true}),
                         [](const auto& variant) { return variant.param.name; });

// Reflectance is below one, so what a shot makes its receivers owe is less than what was sent.
TEST(Unshot, OnlyEverFallsInPlainShooting) {
  for (const Model& model : {cornell(), cube(0.99, {0, 0, 0, 1, 0, 0}), random_open_room(2)}) {
    SolveOptions options;
    options.elements = 90;
    options.settings = lune_settings(16, fraction(1, 50));
    Solution solution(model, options);
    const State& state = solution.state();
    std::uint64_t last[kMaxChannels];
    for (int c = 0; c < state.scene.channels; ++c) {
      last[c] = sum_unshot(state, c).magnitude;
    }
    while (shoot(solution.state()) == Status::ok) {
      for (int c = 0; c < state.scene.channels; ++c) {
        const std::uint64_t now = sum_unshot(state, c).magnitude;
        ASSERT_LE(now, last[c]) << "shot " << state.shots;
        last[c] = now;
      }
    }
    EXPECT_LE(unshot_fraction(state), options.settings.stop);
  }
}

TEST(Unshot, FractionIsThatOfTheWorstChannel) {
  SolveOptions options;
  options.elements = 90;
  options.settings = lune_settings(16, fraction(1, 100));
  Solution solution(cornell(), options);
  const State& state = solution.state();
  while (shoot(solution.state()) == Status::ok) {
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
      worst = std::max(worst, static_cast<double>(sum_unshot(state, c).magnitude) / state.emitted[c]);
    }
    ASSERT_NEAR(unshot_fraction(state).raw / 4294967296.0, worst, 1e-9);
  }
}

// A pool that is too small for some views only, then one that is large enough.
TEST(SpanPool, ThatWasTooSmallForAWhileChangesNothing) {
  SolveOptions options;
  options.elements = 160;
  options.settings = lune_settings(16, fraction(1, 300));
  Solution whole(cornell(), options), interrupted(cornell(), options);
  ASSERT_EQ(whole.run(), Status::converged);
  State& state = interrupted.state();
  const std::uint16_t large = state.work.span_capacity;
  int refusals = 0;
  bool is_small = true;
  for (Status status = Status::ok; status != Status::converged;) {
    const auto half = static_cast<std::uint16_t>(whole.state().work.span_high_water / 2);
    state.work.span_capacity = is_small ? half : large;
    const std::uint32_t shots = state.shots;
    const std::int64_t unshot = ledger(state, 0).unshot, absorbed = ledger(state, 0).absorbed;
    status = shoot(state);
    is_small = status == Status::ok;
    if (status == Status::span_pool_full) {
      ++refusals;
      ASSERT_EQ(state.shots, shots);
      ASSERT_EQ(ledger(state, 0).unshot, unshot);
      ASSERT_EQ(ledger(state, 0).absorbed, absorbed);
      ASSERT_EQ(interrupted.imbalance(), 0);
    }
  }
  EXPECT_GT(refusals, 10);
  EXPECT_LT(refusals, static_cast<int>(state.shots)) << "some views have few spans";
  EXPECT_EQ(interrupted.digest(), whole.digest());
  EXPECT_EQ(state.shots, whole.state().shots);
}

}  // namespace
}  // namespace fixrad::host

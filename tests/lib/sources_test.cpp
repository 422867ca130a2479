// SPDX-License-Identifier: MIT
// Who shoots, and in what order.
#include <gtest/gtest.h>

#include <set>

#include "tests/lib/scenes.h"
#include "tests/lib/sources.h"

namespace fixrad::host {
namespace {

struct Variant {
  const char* name;
  Model (*model)();
  bool overshoot;
};

class Sources : public testing::TestWithParam<Variant> {
 protected:
  SolveOptions options() const {
    SolveOptions options;
    options.elements = 255;
    options.settings = lune_settings(32, fraction(1, 1000));
    options.settings.overshoot = GetParam().overshoot;
    return options;
  }
};

TEST_P(Sources, EmittersSendAllTheirEmissionFirstOneAfterAnother) {
  Solution solution(GetParam().model(), options());
  const State& state = solution.state();
  ShotWatch watch(solution);
  SeenShot seen = {};
  std::vector<bool> has_emitted(state.scene.element_count, false);
  int last = -1;
  bool is_emission_over = false;
  while (watch.next(seen) == Status::ok) {
    if (!seen.shot.is_emission) {
      is_emission_over = true;
      continue;
    }
    ASSERT_FALSE(is_emission_over) << "emission after reflected light";
    ASSERT_EQ(seen.shot.source.kind, SourceKind::element);
    ASSERT_EQ(seen.shot.source.count, 1);
    const std::uint16_t e = seen.shot.source.first;
    ASSERT_GT(int{e}, last);
    last = e;
    has_emitted[e] = true;
    const Element element = flash_read(state.scene.elements, e);
    const fixrad::Material material = flash_read(state.scene.materials, element.material);
    for (int c = 0; c < state.scene.channels; ++c) {
      EXPECT_EQ(seen.shot.amount[c], emitted_flux(state.scene, material, element.area, c));
    }
  }
  for (std::uint16_t e = 0; e < state.scene.element_count; ++e) {
    const glm::dvec3 emission = solution.device().mesh.elements[e].emission;
    EXPECT_EQ(has_emitted[e], emission.x + emission.y + emission.z > 0) << "element " << e;
  }
}

// The bound of a sweep against always picking the largest: no source shoots that has much less.
TEST_P(Sources, EachHoldsElevenSixteenthsOfTheMostWhenThePassBegan) {
  Solution solution(GetParam().model(), options());
  ShotWatch watch(solution);
  SeenShot seen = {};
  int passes = 0;
  while (watch.next(seen) == Status::ok) {
    if (seen.shot.is_emission) {
      continue;
    }
    std::uint64_t flux = 0;
    for (int c = 0; c < solution.state().scene.channels; ++c) {
      flux += magnitude(seen.shot.unshot[c].raw);
    }
    ASSERT_GE(flux, 11 * seen.largest / 16) << "shot " << solution.state().shots;
    passes += seen.begins_pass ? 1 : 0;
  }
  EXPECT_GT(passes, 3) << "one pass alone shows little";
}

TEST_P(Sources, OnlyEverGrowFromElementToPatchToFaceAndEachKindOccurs) {
  Solution solution(GetParam().model(), options());
  ShotWatch watch(solution);
  SeenShot seen = {};
  SourceKind kind = SourceKind::element;
  std::set<SourceKind> kinds;
  while (watch.next(seen) == Status::ok) {
    ASSERT_GE(seen.shot.source.kind, kind) << "shot " << solution.state().shots;
    kind = seen.shot.source.kind;
    if (!seen.shot.is_emission) {
      kinds.insert(kind);
    }
  }
  EXPECT_EQ(kinds, (std::set<SourceKind>{SourceKind::element, SourceKind::patch, SourceKind::face}));
}

TEST_P(Sources, SendWhatTheyHaveAndNeverMoreThanTwice) {
  Solution solution(GetParam().model(), options());
  ShotWatch watch(solution);
  SeenShot seen = {};
  bool has_lent = false;
  while (watch.next(seen) == Status::ok) {
    for (int c = 0; c < solution.state().scene.channels; ++c) {
      const std::int64_t unshot = seen.shot.unshot[c].raw, amount = seen.shot.amount[c].raw;
      has_lent = has_lent || amount > unshot;
      const bool is_single = seen.shot.source.count == 1;
      if (is_single && unshot > 0) {  // elements of a group may lend while others owe
        ASSERT_LE(amount, 2 * unshot);
      }
      if (seen.shot.source.kind == SourceKind::face) {
        ASSERT_EQ(amount, unshot) << "faces keep account to the unit and never lend";
      }
    }
  }
  EXPECT_EQ(has_lent, GetParam().overshoot);
}

TEST_P(Sources, OfAFaceOrPatchLieOnOneFaceAndCountEveryElementOnce) {
  const Solution solution(GetParam().model(), options());
  const Scene& scene = solution.state().scene;
  for (const SourceKind kind : {SourceKind::element, SourceKind::patch, SourceKind::face}) {
    std::vector<int> times(scene.element_count, 0);
    for (const EyeSource& source : sources_of(scene, kind)) {
      ASSERT_GE(source.count, 1);
      for (std::uint16_t i = 0; i < source.count; ++i) {
        const std::uint16_t e = source_element(scene, source, i);
        ++times.at(e);
        ASSERT_EQ(flash_read(scene.elements, e).face, source.face);
      }
    }
    EXPECT_EQ(times, std::vector<int>(scene.element_count, 1));
  }
}

Model shut_room() {
  return random_closed_room(7);
}

INSTANTIATE_TEST_SUITE_P(Scene, Sources,
                         testing::Values(Variant{"Cornell", cornell, false},
                                         Variant{"CornellOvershooting", cornell, true},
                                         Variant{"ShutRoom", shut_room, false},
                                         Variant{"ShutRoomOvershooting", shut_room, true}),
                         [](const auto& variant) { return variant.param.name; });

}  // namespace
}  // namespace fixrad::host

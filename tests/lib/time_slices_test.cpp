// SPDX-License-Identifier: MIT
// step(budget): a shot in slices is the shot in one piece, to the bit; it can be given up at any time.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

using Digest = std::uint64_t;

struct Variant {
  std::string name;
  std::function<Model()> model;
  Settings settings;
  std::uint32_t elements;
  bool has_sights;
};

Settings changed(Settings settings, const std::function<void(Settings&)>& change) {
  change(settings);
  return settings;
}

Settings pairs(Engine engine) {
  return changed(lune_settings(8, fraction(1, 20)), [engine](Settings& s) { s.engine = engine; });
}

// The room of a material in grey.
Model grey_room() {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.6));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.1), glm::dvec3(3.0));
  builder.room({0, 0, 0}, {4, 3, 4}, {wall, wall, wall, lamp, wall, wall});
  builder.box({1, 0, 1}, {2, 1, 2}, 0.4, wall);
  return builder.model();
}

Model buried_room() {
  return room_with_box(Stand::without_bottom, 0.3);
}

// In open space, so that elements none of whose eyes is clear still send.
Model open_room() {
  return random_open_room(7);
}

std::vector<Variant> variants() {
  const Settings lunes = lune_settings(32, fraction(1, 200));
  return {
      {"Lunes", cornell, lunes, 120, true},
      {"Probed", cornell, lunes, 120, false},
      {"Grey", grey_room, lunes, 120, false},
      {"Hemicube", cornell, settings_with(16, fraction(1, 50)), 120, true},
      {"Pixels", cornell,
       changed(settings_with(8, fraction(1, 50)), [](Settings& s) { s.engine = hemicube_pixels; }), 120,
       true},
      {"Contours",
       [] {
         return cube(0.5, {1, 0, 0, 0, 0, 0});
       },
       pairs(contour_row), 60, true},
      {"Rays", buried_room, pairs(ray_row), 60, false},
      {"NearField", cornell, changed(lunes, [](Settings& s) { s.near_field = correct_near_field; }), 80,
       true},
      {"Overshooting", cornell, changed(lunes, [](Settings& s) { s.overshoot = true; }), 120, true},
      {"ManyEyes", cornell, changed(lunes, [](Settings& s) { s.flux_per_eye = fraction(1, 500); }), 120,
       false},
      {"Patches", cornell, changed(lunes, [](Settings& s) { s.flux_per_row = fraction(1, 100); }), 200,
       false},
      {"Buried", buried_room, changed(lunes, [](Settings& s) { s.flux_per_eye = fraction(1, 50); }), 150,
       false},
      {"Open", open_room, lunes, 120, false},
  };
}

SolveOptions options_of(const Variant& variant) {
  SolveOptions options;
  options.elements = variant.elements;
  options.spans = 400;
  options.settings = variant.settings;
  return options;
}

Solution begin(const Variant& variant) {
  return Solution(variant.model(), options_of(variant), variant.has_sights);
}

// What can be read of a solution.
struct Seen {
  std::vector<std::int32_t> received, accounts;
  std::vector<std::int64_t> ledger;
  std::uint32_t shots, eyes, withdrawn;
  std::uint8_t turn;
  std::uint16_t next_emitter;

  bool operator==(const Seen& o) const {
    return received == o.received && ledger == o.ledger && shots == o.shots && eyes == o.eyes &&
           withdrawn == o.withdrawn && turn == o.turn;
  }
};

Seen seen(const State& state) {
  Seen all = {{}, {}, {}, state.shots, state.eyes, state.withdrawn, state.turn, state.next_emitter};
  const std::uint32_t channels = state.scene.channels;
  all.received.assign(state.received, state.received + state.scene.element_count * channels);
  const std::uint32_t words = channels * account_words(state.scene.element_count, state.scene.face_count);
  all.accounts.assign(state.accounts, state.accounts + words);
  for (int c = 0; c < state.scene.channels; ++c) {
    const Ledger sum = ledger(state, c);
    all.ledger.insert(all.ledger.end(), {sum.absorbed, sum.unshot, sum.escaped, sum.back});
  }
  return all;
}

class TimeSlices : public testing::TestWithParam<Variant> {
 protected:
  // The solution in one piece, once a variant.
  static const Seen& whole(const Variant& variant, Digest& digest) {
    static std::string name;
    static Seen result;
    static Digest found;
    if (name != variant.name) {
      Solution solution = begin(variant);
      EXPECT_EQ(solution.run(), Status::converged);
      EXPECT_EQ(solution.imbalance(), 0);
      result = seen(solution.state());
      found = solution.digest();
      name = variant.name;
    }
    digest = found;
    return result;
  }

  static void expect_whole(const Variant& variant, Solution& solution, Status status) {
    Digest digest = 0;
    const Seen& expected = whole(variant, digest);
    EXPECT_EQ(status, Status::converged);
    EXPECT_TRUE(seen(solution.state()) == expected);
    EXPECT_EQ(solution.digest(), digest);
    EXPECT_EQ(solution.imbalance(), 0);
  }
};

TEST_P(TimeSlices, OfAnyLengthGiveTheBitsOfUninterruptedShots) {
  for (const std::uint32_t budget : {1u, 2u, 7u, 1000u, 0u, 0xffffffffu}) {
    Solution solution = begin(GetParam());
    Status status = Status::ok;
    while (status == Status::ok || status == Status::in_progress) {
      status = shoot_for(solution.state(), budget);
    }
    SCOPED_TRACE("budget " + std::to_string(budget));
    expect_whole(GetParam(), solution, status);
  }
}

// Given up once in every shot, each time after another number of slices, and once again.
TEST_P(TimeSlices, GiveTheSameBitsWhereShotsAreGivenUp) {
  Solution solution = begin(GetParam());
  State& state = solution.state();
  Status status = Status::ok;
  std::uint32_t slices = 0, given_up = 0;
  while (status == Status::ok || status == Status::in_progress) {
    status = shoot_for(state, 1);
    slices = status == Status::ok ? 0 : slices + 1;
    if (slices == state.shots % 37 + 1 || slices == 60) {
      abandon_shot(state);
      ++given_up;
    }
  }
  EXPECT_GT(given_up, state.shots / 4);
  expect_whole(GetParam(), solution, status);
}

TEST_P(TimeSlices, BookNothingBeforeTheShotIsComplete) {
  Solution solution = begin(GetParam());
  State& state = solution.state();
  Seen before = seen(state);
  SourceKind kind = state.sweep.kind;
  std::uint32_t compared = 0;
  Status status = Status::ok;
  while ((status == Status::ok || status == Status::in_progress) && compared < 3000) {
    status = shoot_for(state, 3);
    const Seen now = seen(state);
    if (status == Status::in_progress) {
      ASSERT_TRUE(now == before);
      ASSERT_TRUE(state.sweep.kind != kind || now.accounts == before.accounts);
      ++compared;
    }
    before = now;
    kind = state.sweep.kind;
  }
  EXPECT_GT(compared, 100u);
}

INSTANTIATE_TEST_SUITE_P(Solving, TimeSlices, testing::ValuesIn(variants()),
                         [](const auto& variant) { return variant.param.name; });

// Lune rows that count themselves.
int rows_done;
Status counted_lunes(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                     FormFactorRow& row) {
  const int before = work.at.next;
  const Status status = lune_rows(scene, table, sample, work, row);
  // The beginning of the view is a unit too.
  rows_done += (status == Status::ok ? (1 << table.resolution_log2) + 1 : work.at.next) - before;
  return status;
}

TEST(Budget, IsNeverExceededAndAllOfItIsUsed) {
  for (const int budget : {1, 2, 5, 13, 64}) {
    SolveOptions options = options_of(variants().front());
    options.settings.engine = counted_lunes;
    Solution solution(cornell(), options, true);
    Status status = Status::ok;
    int most = 0, full = 0;
    while (status == Status::ok || status == Status::in_progress) {
      rows_done = 0;
      status = shoot_for(solution.state(), static_cast<std::uint32_t>(budget));
      ASSERT_LE(rows_done, budget);
      most = std::max(most, rows_done);
      full += rows_done == budget ? 1 : 0;
    }
    EXPECT_EQ(status, Status::converged);
    EXPECT_EQ(most, budget);
    EXPECT_GT(full, 3);
  }
}

TEST(Budget, OfOneEndsAndTakesAsManyCallsAsThereAreUnits) {
  Solution one = begin(variants().front()), seven = begin(variants().front());
  const auto calls = [](Solution& solution, std::uint32_t budget) {
    std::uint32_t n = 0;
    Status status = Status::ok;
    while (status != Status::converged) {
      status = shoot_for(solution.state(), budget);
      ++n;
    }
    return n;
  };
  const std::uint32_t ones = calls(one, 1), sevens = calls(seven, 7);
  const std::uint32_t shots = one.state().shots;
  EXPECT_GT(ones, shots * 5);
  // A call ends early where its shot is complete.
  EXPECT_GE(sevens, ones / 7);
  EXPECT_LE(sevens, ones / 7 + shots + 1);
}

// Else the variants would prove less than they say.
TEST(Slices, EndInEveryStageOfAShotAndWithEveryKindOfSource) {
  std::set<SamplingStage> stages;
  std::set<SourceKind> kinds;
  for (const Variant& variant : variants()) {
    Solution solution = begin(variant);
    for (Status status = Status::ok; status != Status::converged;) {
      status = shoot_for(solution.state(), 1);
      if (status == Status::in_progress) {
        stages.insert(solution.state().sampling.stage);
        kinds.insert(solution.state().sweep.kind);
      }
    }
  }
  for (int stage = 0; stage <= static_cast<int>(SamplingStage::corrected); ++stage) {
    EXPECT_EQ(stages.count(static_cast<SamplingStage>(stage)), 1u) << "stage " << stage;
  }
  EXPECT_EQ(kinds.size(), 3u);
}

TEST(Slices, MayBeInterruptedByAGather) {
  const Variant variant = variants().front();
  Solution whole = begin(variant), gathered = begin(variant);
  ASSERT_EQ(whole.run(), Status::converged);
  State& state = gathered.state();
  const Radiosity no_ambient[kMaxChannels] = {};
  Status status = Status::ok;
  for (std::uint32_t calls = 1; status != Status::converged; ++calls) {
    status = shoot_for(state, 9);
    if (calls % 61 == 0) {
      Irradiance irradiance = {};
      const EyePoint eye = element_eye(state.scene, calls % state.scene.element_count);
      ASSERT_EQ(gather_irradiance(state, kLunes[0], nullptr, eye, true, no_ambient, irradiance), Status::ok);
    }
  }
  EXPECT_EQ(gathered.digest(), whole.digest());
}

TEST(Slices, EndInAStatusWhereTheSpanPoolIsFullAndLeaveTheSolution) {
  SolveOptions options = options_of(variants().front());
  options.spans = 4;
  Solution solution(cornell(), options, true);
  const Seen before = seen(solution.state());
  for (int attempt = 0; attempt < 2; ++attempt) {
    Status status = Status::in_progress;
    while (status == Status::in_progress) {
      status = shoot_for(solution.state(), 1);
    }
    EXPECT_EQ(status, Status::span_pool_full);
    EXPECT_TRUE(seen(solution.state()) == before);
    EXPECT_TRUE(seen(solution.state()).accounts == before.accounts);
  }
}

}  // namespace
}  // namespace fixrad::host

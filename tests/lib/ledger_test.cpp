// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/lib/gathered.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kScenesOfEachKind = 16;

struct Variant {
  const char* name;
  Engine engine;
  bool overshoot;
};

class LedgerOf : public testing::TestWithParam<Variant> {
 protected:
  SolveOptions options() const {
    SolveOptions options;
    options.elements = 70;
    options.patches = 45;
    options.settings = GetParam().engine == lune_rows ? lune_settings(16, fraction(1, 50))
                                                      : settings_with(8, fraction(1, 50));
    options.settings.engine = GetParam().engine;
    options.settings.overshoot = GetParam().overshoot;
    options.settings.flux_per_eye = fraction(1, 20);
    return options;
  }

  static void expect_balance_after_every_shot(Solution& solution, std::uint32_t seed) {
    ASSERT_EQ(solution.imbalance(), 0) << "seed " << seed << " before the first shot";
    Status status = Status::ok;
    while ((status = shoot(solution.state())) == Status::ok) {
      ASSERT_EQ(solution.imbalance(), 0) << "seed " << seed << " shot " << solution.state().shots;
    }
    ASSERT_EQ(status, Status::converged) << "seed " << seed << ' ' << describe(status);
    ASSERT_GT(solution.state().shots, 0u);
  }
};

TEST_P(LedgerOf, RandomClosedRoomsBalancesAfterEveryShot) {
  for (std::uint32_t seed = 0; seed < kScenesOfEachKind; ++seed) {
    Solution solution(random_closed_room(seed), options());
    expect_balance_after_every_shot(solution, seed);
    const State& state = solution.state();
    ASSERT_TRUE(state.is_closed) << seed;
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(state.escaped[c], 0) << "seed " << seed;
      EXPECT_EQ(state.back[c], 0) << "seed " << seed;
    }
  }
}

TEST_P(LedgerOf, RandomOpenRoomsBalancesAfterEveryShot) {
  std::int64_t escaped = 0, back = 0;
  for (std::uint32_t seed = 0; seed < kScenesOfEachKind; ++seed) {
    Solution solution(random_open_room(seed), options());
    expect_balance_after_every_shot(solution, seed);
    escaped += solution.state().escaped[0];
    back += solution.state().back[0];
  }
  EXPECT_GT(escaped, 0) << "scenes that lose nothing test nothing";
  EXPECT_GT(back, 0);
}

INSTANTIATE_TEST_SUITE_P(Engine, LedgerOf,
                         testing::Values(Variant{"Rows", hemicube_rows, false},
                                         Variant{"RowsOvershooting", hemicube_rows, true},
                                         Variant{"Pixels", hemicube_pixels, false},
                                         Variant{"PixelsOvershooting", hemicube_pixels, true},
                                         Variant{"Lunes", lune_rows, false},
                                         Variant{"LunesOvershooting", lune_rows, true}),
                         [](const auto& variant) { return variant.param.name; });

TEST(Ledger, BalancesAfterGatheringRandomScenes) {
  for (std::uint32_t seed = 100; seed < 106; ++seed) {
    for (const bool is_closed : {true, false}) {
      SolveOptions options;
      options.elements = 60;
      options.settings = settings_with(8, fraction(1, 1000));
      Solution solution(is_closed ? random_closed_room(seed) : random_open_room(seed), options);
      gather(solution);
      ASSERT_EQ(solution.imbalance(), 0) << "seed " << seed << (is_closed ? " closed" : " open");
      EXPECT_GT(ledger(solution.state(), 0).absorbed, 0);
    }
  }
}

TEST(Ledger, AbsorbsNearlyEverythingInAClosedBox) {
  SolveOptions options;
  options.settings = settings_with(16, fraction(1, 1000));
  Solution solution(cube(0.5, {0, 0, 0, 1, 0, 0}), options);
  ASSERT_EQ(solution.run(), Status::converged);
  const Ledger total = ledger(solution.state(), 0);
  EXPECT_GT(static_cast<double>(total.absorbed), 0.99 * static_cast<double>(total.emitted));
  EXPECT_EQ(total.escaped + total.back, 0);
  for (std::uint32_t e = 0; e < solution.device().elements.size(); ++e) {
    ASSERT_GT(solution.state().received[e], 0) << "element " << e << " is left dark";
  }
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

SolveOptions options_of(std::uint32_t elements) {
  SolveOptions options;
  options.elements = elements;
  options.settings = settings_with(16, fraction(1, 10000));
  return options;
}

TEST(Ambient, NeverEntersTheLedger) {
  Solution watched(cornell(), options_of(120)), alone(cornell(), options_of(120));
  for (int i = 0; i < 60; ++i) {
    const Ledger before = ledger(watched.state(), 1);
    const std::vector<double> shown = watched.radiosities(1, true);
    ASSERT_GT(shown[0], 0.0);
    const Ledger after = ledger(watched.state(), 1);
    ASSERT_EQ(after.absorbed, before.absorbed);
    ASSERT_EQ(after.unshot, before.unshot);
    ASSERT_EQ(after.imbalance(), 0);
    ASSERT_EQ(watched.run(1), Status::ok);
  }
  ASSERT_EQ(alone.run(60), Status::ok);
  EXPECT_EQ(watched.digest(), alone.digest());
}

TEST(Ambient, ShortensTheDistanceToTheSolutionEarlyOn) {
  for (const Model& model : {cornell(), cube(0.7, {0, 0, 0, 1, 0, 0})}) {
    Solution converged(model, options_of(120)), early(model, options_of(120));
    ASSERT_EQ(converged.run(), Status::converged);
    const std::vector<double> solution = converged.radiosities(1 % converged.device().channels);
    for (int i = 0; i < 5; ++i) {
      ASSERT_EQ(early.run(10), Status::ok);
      const int channel = 1 % early.device().channels;
      const double without = relative_difference(early.radiosities(channel), solution).mean;
      const double with = relative_difference(early.radiosities(channel, true), solution).mean;
      EXPECT_LT(with, without) << "after " << early.state().shots << " shots";
    }
  }
}

// In a furnace the estimate is exact from the start: unshot / (1 - reflectance) is all that is to come.
TEST(Ambient, IsExactInAFurnace) {
  constexpr double kBound = 1e-4;
  const Solution start(cube(0.6, {1, 1, 1, 1, 1, 1}), options_of(54));
  for (const double b : start.radiosities(0, true)) {
    ASSERT_NEAR(b * (1 - 0.6), 1.0, kBound);
  }
}

TEST(Ambient, VanishesWithTheUnshotFlux) {
  Solution solution(cube(0.5, {1, 0, 0, 0, 0, 0}), options_of(54));
  ASSERT_EQ(solution.run(), Status::converged);
  EXPECT_LT(relative_difference(solution.radiosities(0, true), solution.radiosities()).largest, 0.001);
}

}  // namespace
}  // namespace fixrad::host

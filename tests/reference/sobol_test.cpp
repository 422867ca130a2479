// SPDX-License-Identifier: MIT
#include "host_sim/reference/sobol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace fixrad::host {
namespace {

TEST(ScrambledSobol, EveryIntervalOfEachCoordinateHasItsPoint) {
  constexpr std::size_t kPoints = 1024;
  for (const std::uint64_t seed : {1U, 2U}) {
    ScrambledSobol set(seed);
    std::array<std::set<int>, kSobolDimensions> intervals;
    for (std::size_t k = 0; k < kPoints; ++k) {
      const auto x = set.next();
      for (std::size_t d = 0; d < x.size(); ++d) {
        ASSERT_GE(x[d], 0.0);
        ASSERT_LT(x[d], 1.0);
        intervals[d].insert(static_cast<int>(x[d] * kPoints));
      }
    }
    for (const std::set<int>& of_coordinate : intervals) {
      EXPECT_EQ(of_coordinate.size(), kPoints);
    }
  }
}

TEST(ScrambledSobol, EveryElementaryBoxOfTheFirstTwoCoordinatesHasItsPoint) {
  // The first two coordinates are a (0, 2)-sequence: one point in each of the 256 boxes, whatever their
  // shape.
  for (int log_columns = 0; log_columns <= 8; ++log_columns) {
    const int columns = 1 << log_columns;
    const int rows = 256 / columns;
    ScrambledSobol set(7);
    std::set<std::pair<int, int>> boxes;
    for (int k = 0; k < 256; ++k) {
      const auto x = set.next();
      boxes.insert({static_cast<int>(x[0] * columns), static_cast<int>(x[1] * rows)});
    }
    EXPECT_EQ(boxes.size(), 256U) << columns;
  }
}

TEST(ScrambledSobol, IntegratesAProductFarBetterThanRandomPoints) {
  // The product of 1 + (x - 1/2) over all coordinates has mean 1; random points would be off by about
  // sqrt(((13 / 12)^10 - 1) / 4096) = 0.017.
  double worst = 0.0;
  double mean = 0.0;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    ScrambledSobol set(seed);
    double sum = 0.0;
    for (int k = 0; k < 4096; ++k) {
      double product = 1.0;
      for (const double x : set.next()) {
        product *= 0.5 + x;
      }
      sum += product / 4096.0;
    }
    worst = std::max(worst, std::abs(sum - 1.0));
    mean += sum / 16.0;
  }
  EXPECT_LT(worst, 0.003);
  EXPECT_NEAR(mean, 1.0, 0.0006);
  EXPECT_GT(worst, 0.0) << "all copies are the same";
}

}  // namespace
}  // namespace fixrad::host

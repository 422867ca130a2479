// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <limits>

#include "host_sim/sweep/sweep.h"

namespace fixrad::host {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Frontier, HoldsThePointsThatNoOtherBeatsInBothByRisingCost) {
  //  error
  //    4  0
  //    3     . 3
  //    2  .  1
  //    1        2   4 is dearer than 2 and no better
  EXPECT_THAT(pareto_frontier({1, 2, 3, 2.5, 4}, {4, 2, 1, 3, 1}), ElementsAre(0, 1, 2));
}

TEST(Frontier, KeepsOneOfEqualPoints) {
  EXPECT_THAT(pareto_frontier({1, 1, 1}, {2, 2, 2}), ElementsAre(0));
}

TEST(Frontier, OfEqualCostsKeepsTheSmallerError) {
  EXPECT_THAT(pareto_frontier({1, 1}, {3, 2}), ElementsAre(1));
}

TEST(Frontier, LeavesOutWhatHasNoCost) {
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_THAT(pareto_frontier({none, 1}, {0, 1}), ElementsAre(1));
  EXPECT_THAT(pareto_frontier({}, {}), IsEmpty());
}

}  // namespace
}  // namespace fixrad::host

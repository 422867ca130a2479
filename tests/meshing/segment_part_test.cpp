// SPDX-License-Identifier: MIT
#include "host_sim/meshing/segment_part.h"

#include <gtest/gtest.h>

namespace fixrad::host {
namespace {

TEST(SegmentPart, IsAllOfTheSegmentUntilSomethingIsGivenUp) {
  SegmentPart part;
  part.keep_where(0, 3);
  EXPECT_EQ(part.begin, 0);
  EXPECT_EQ(part.end, 1);
}

TEST(SegmentPart, EndsWhereAFunctionChangesItsSign) {
  SegmentPart part;
  part.keep_where(-1, 3);
  part.keep_where(1, -1);
  EXPECT_DOUBLE_EQ(part.begin, 0.25);
  EXPECT_DOUBLE_EQ(part.end, 0.5);
  EXPECT_DOUBLE_EQ(part.length(), 0.25);
}

TEST(SegmentPart, IsAPointWhereOnlyAnEndIsKept) {
  SegmentPart part;
  part.keep_where(0, -2);
  EXPECT_EQ(part.begin, part.end);
  EXPECT_EQ(part.length(), 0);
}

TEST(SegmentPart, IsEmptyWhereNothingIsKept) {
  SegmentPart outside, torn;
  outside.keep_where(-1, -1);
  torn.keep_where(-3, 1);
  torn.keep_where(1, -3);
  EXPECT_LT(outside.end, outside.begin);
  EXPECT_LT(torn.end, torn.begin);
  EXPECT_EQ(outside.length(), 0);
  EXPECT_EQ(torn.length(), 0);
}

}  // namespace
}  // namespace fixrad::host

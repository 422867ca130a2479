// SPDX-License-Identifier: MIT
// Every macro must be able to fail: a program of its own, whose failures are counted.
#include <stdint.h>

#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

enum class Colour : uint8_t { red, green };

// Not known to the compiler, so that no comparison is decided before run time.
int32_t hidden(int32_t value) {
  volatile int32_t copy = value;
  return copy;
}

TEST(Failing, ExpectEq) {
  EXPECT_EQ(hidden(-3), 70000);
}
TEST(Failing, ExpectNe) {
  EXPECT_NE(hidden(2), 2);
}
TEST(Failing, ExpectLt) {
  EXPECT_LT(hidden(2), 2);
}
TEST(Failing, ExpectLe) {
  EXPECT_LE(hidden(3), 2);
}
TEST(Failing, ExpectGt) {
  EXPECT_GT(hidden(2), 2);
}
TEST(Failing, ExpectGe) {
  EXPECT_GE(hidden(1), 2);
}
TEST(Failing, ExpectTrue) {
  EXPECT_TRUE(hidden(1) == 2);
}
TEST(Failing, ExpectFalse) {
  EXPECT_FALSE(hidden(2) == 2);
}
TEST(Failing, ExpectNear) {
  EXPECT_NEAR(hidden(-5), 5, 9);
}
TEST(Failing, EnumerationsAreCompared) {
  EXPECT_EQ(hidden(1) == 1 ? Colour::red : Colour::green, Colour::green);
}
TEST(Failing, AllBitsOf64Count) {
  EXPECT_EQ(static_cast<uint64_t>(hidden(1)) << 63, 0u);
}
TEST(Failing, AFailureIsNotForgiven) {
  EXPECT_TRUE(hidden(0) == 1);
  EXPECT_TRUE(hidden(0) == 0);
}

bool went_on = false;
TEST(Failing, AssertEq) {
  ASSERT_EQ(hidden(1), 2);
  went_on = true;
}
TEST(Failing, AssertTrue) {
  ASSERT_TRUE(hidden(1) == 2);
  went_on = true;
}
TEST(Failing, AssertNear) {
  ASSERT_NEAR(hidden(1), 3, 1);
  went_on = true;
}

TEST(Passing, AnAssertionThatFailsEndsItsTest) {
  EXPECT_FALSE(went_on);
}
TEST(Passing, NearIncludesTheTolerance) {
  EXPECT_NEAR(hidden(-5), 5, 10);
  EXPECT_NEAR(hidden(5), -5, 10);
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

using UnsignedFraction = Q<uint16_t, 16>;

TEST(QFormat, SumsStayInTheirFormat) {
  const Flux a = Flux::from_raw(2000000000);
  const Flux b = Flux::from_raw(-1999999999);
  EXPECT_EQ((a + b).raw, 1);
  EXPECT_EQ((a - a).raw, 0);
  Flux sum = a;
  sum += b;
  EXPECT_TRUE(sum == a + b);
  sum -= b;
  EXPECT_TRUE(sum == a);
}

TEST(QFormat, SixteenBitFormatsWrapAtTheirOwnWidth) {
  const UnsignedFraction one_less = UnsignedFraction::from_raw(0xffff);
  EXPECT_EQ((one_less + UnsignedFraction::from_raw(2)).raw, 1u);
  EXPECT_EQ((UnsignedFraction::from_raw(0) - UnsignedFraction::from_raw(1)).raw, 0xffffu);
}

TEST(QFormat, OrdersByValue) {
  const Flux less = Flux::from_raw(-70000);
  const Flux more = Flux::from_raw(70000);
  EXPECT_TRUE(less < more && less <= more && more > less && more >= less && less != more);
  EXPECT_TRUE(Reflectance::from_raw(0xffffffffu) > Reflectance::from_raw(0x80000000u));
}

TEST(QFormat, AFormatIsAsLargeAsItsInteger) {
  EXPECT_EQ(sizeof(Flux), sizeof(int32_t));
  EXPECT_EQ(sizeof(Reflectance), sizeof(uint32_t));
  EXPECT_EQ(sizeof(UnsignedFraction), sizeof(uint16_t));
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

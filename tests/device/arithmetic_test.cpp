// SPDX-License-Identifier: MIT
// The primitives against schoolbook arithmetic: where a core has an own body for one, this is what holds it
// to the plain one.
#include "lib/fixed/arithmetic.h"

#include "lib/fixed/short_flux.h"
#include "lib/fixed/vec3.h"
#include "lib/form_factor/row.h"
#include "lib/transport/state.h"
#include "tests/device/random.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

constexpr int32_t kMostFlux = 2147483647;
constexpr uint16_t kRounds = 3000;

// Borders of 8, 16 and 32 bits, where a carry can go wrong.
constexpr uint32_t kCorners[] = {0,          1,          2,          0xff,       0x100,      0xffff,
                                 0x10000,    0x10001,    0xfffff,    0x100000,   0x7fffffff, 0x80000000,
                                 0x80000001, 0xffff0000, 0xfffeffff, 0xfffffffe, 0xffffffff};

// Bit by bit, with additions of 32 bits only.
struct Wide {
  uint32_t high, low;
};

Wide add(Wide a, Wide b) {
  const uint32_t low = a.low + b.low;
  return {a.high + b.high + (low < a.low ? 1u : 0u), low};
}

Wide schoolbook_product(uint32_t a, uint32_t b) {
  Wide sum = {0, 0};
  for (uint8_t bit = 32; bit-- > 0;) {
    sum = add(sum, sum);
    if ((b >> bit & 1u) != 0) {
      sum = add(sum, {0, a});
    }
  }
  return sum;
}

// floor((flux sum + phase) / 2^20), sum <= 2^20.
uint32_t floor_of_product(uint32_t flux, uint32_t sum, uint32_t phase) {
  const Wide total = add(schoolbook_product(flux, sum), {0, phase});
  return total.high << 12 | total.low >> 20;
}

// Numbers of every length, so that short operands come as often as long ones.
uint32_t of_any_length(Random& random) {
  const uint32_t bits = random.bits();
  return bits >> random.between(0, 31);
}

// Two of them add up to less than 2^31.
int32_t signed_flux(Random& random) {
  const int32_t flux = static_cast<int32_t>(of_any_length(random) >> 2);
  return random.bits() >> 31 != 0 ? flux : -flux;
}

Reflectance reflectance_of(uint32_t raw) {
  return Reflectance::from_raw(raw);
}

TEST(Arithmetic, RightShiftOfNegativesRoundsTowardsMinusInfinity) {
  constexpr int32_t values[] = {-1, -2, -3, -1000001, -kMostFlux, -kMostFlux - 1};
  for (const int32_t a : values) {
    for (uint8_t shift = 0; shift < 32; ++shift) {
      // floor(a / 2^n) = -1 - floor((-1 - a) / 2^n), and -1 - a is not negative.
      const uint32_t below = static_cast<uint32_t>(-1 - a) >> shift;
      ASSERT_EQ(floor_shift(a, shift), -1 - static_cast<int32_t>(below));
    }
  }
}

TEST(Arithmetic, BitLengthIsOneMoreThanTheFloorOfLog2) {
  EXPECT_EQ(bit_length(0), 0);
  for (uint8_t n = 0; n < 32; ++n) {
    const uint32_t power = static_cast<uint32_t>(1) << n;
    EXPECT_EQ(bit_length(power), n + 1);
    EXPECT_EQ(bit_length(power | (power - 1)), n + 1);
  }
}

TEST(Arithmetic, MagnitudeOfTheSmallestIntegerIsTwoToThe31) {
  EXPECT_EQ(magnitude(-kMostFlux - 1), 0x80000000u);
  EXPECT_EQ(magnitude(-5), 5u);
  EXPECT_EQ(magnitude(kMostFlux), 0x7fffffffu);
}

// Every body of the product, whichever this core uses.
void expect_schoolbook(uint32_t a, uint32_t b) {
  const Wide exact = schoolbook_product(a, b);
  const uint64_t product = static_cast<uint64_t>(exact.high) << 32 | exact.low;
  ASSERT_EQ(wide_product_plain(a, b), product);
  ASSERT_EQ(wide_product_halves(a, b), product);
  ASSERT_EQ(wide_product(a, b), product);
  ASSERT_EQ(mul_high(a, b), exact.high);
}

TEST(WideProduct, IsTheSchoolbookProduct) {
  for (const uint32_t a : kCorners) {
    for (const uint32_t b : kCorners) {
      expect_schoolbook(a, b);
    }
  }
  Random random(1);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const uint32_t a = of_any_length(random);
    expect_schoolbook(a, of_any_length(random));
  }
}

TEST(Arithmetic, ProductsOfNegativesCarryTheirSignInto64Bits) {
  Random random(4);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const uint32_t a = of_any_length(random) >> 1;
    const uint32_t b = of_any_length(random) >> 1;
    const Wide exact = schoolbook_product(a, b);
    const int64_t product = static_cast<int64_t>(exact.high) << 32 | exact.low;
    const int32_t x = static_cast<int32_t>(a);
    const int32_t y = static_cast<int32_t>(b);
    ASSERT_EQ(static_cast<int64_t>(-x) * y, -product);
    ASSERT_EQ(static_cast<int64_t>(-x) * -y, product);
  }
}

TEST(Arithmetic, WideDivisionLeavesARemainderBelowTheDivisor) {
  Random random(5);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const uint64_t dividend = static_cast<uint64_t>(of_any_length(random)) << 32 | random.bits();
    const uint32_t divisor = of_any_length(random) | 1u;
    const uint64_t quotient = dividend / divisor;
    ASSERT_LE(quotient * divisor, dividend);
    ASSERT_LT(dividend - quotient * divisor, static_cast<uint64_t>(divisor));
  }
}

TEST(Arithmetic, BlockNormaliseScalesTheLargestComponentIntoItsBits) {
  Random random(6);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const Vec3 a = {static_cast<int32_t>(random.between(0, 2000000)) - 1000000,
                    static_cast<int32_t>(random.between(0, 600)) - 300,
                    static_cast<int32_t>(random.between(0, 10)) - 5};
    const Vec3 b = block_normalise(a, 14);
    ASSERT_LE(max_magnitude(b), static_cast<uint32_t>(1) << 14);
    ASSERT_GE(max_magnitude(b), max_magnitude(a) == 0 ? 0u : static_cast<uint32_t>(1) << 13);
    ASSERT_TRUE(b.x == 0 || (b.x < 0) == (a.x < 0));
  }
  EXPECT_EQ(max_magnitude(block_normalise({0, 0, 0}, 14)), 0u);
}

TEST(Reflect, IsTheUpperHalfOfTheProductAndOddInWhatWasReceived) {
  Random random(7);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const uint32_t received = of_any_length(random) >> 1;
    const uint32_t reflectance = of_any_length(random);
    const int32_t raw = static_cast<int32_t>(received);
    const int32_t part = static_cast<int32_t>(schoolbook_product(reflectance, received).high);
    ASSERT_EQ(reflect(reflectance_of(reflectance), Flux::from_raw(raw)).raw, part);
    ASSERT_EQ(reflect(reflectance_of(reflectance), Flux::from_raw(-raw)).raw, -part);
    ASSERT_LE(part, raw);
  }
  EXPECT_EQ(reflect(reflectance_of(0xffffffffu), Flux::from_raw(kMostFlux)).raw, kMostFlux - 1);
}

TEST(ReflectMore, IsTheDifferenceOfTwoTotals) {
  Random random(8);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const Flux received = Flux::from_raw(signed_flux(random));
    const Flux share = Flux::from_raw(signed_flux(random));
    const Reflectance reflectance = Reflectance::from_raw(of_any_length(random));
    const Flux difference = reflect(reflectance, received + share) - reflect(reflectance, received);
    ASSERT_EQ(reflect_more(reflectance, received, share).raw, difference.raw);
  }
}

TEST(FluxCutter, PiecesAddUpToTheWhole) {
  Random random(9);
  for (uint16_t i = 0; i < kRounds / 10; ++i) {
    const int32_t flux = signed_flux(random);
    FluxCutter cutter(Flux::from_raw(flux), random.bits() >> 12);
    int64_t total = 0;
    for (uint32_t left = kRowOne; left > 0;) {
      const uint32_t step = random.bits() >> random.between(14, 28);
      const uint32_t part = step < left ? step : left;
      const int32_t piece = cutter.cut(part).raw;
      ASSERT_TRUE(piece == 0 || (piece < 0) == (flux < 0));
      total += piece;
      left -= part;
    }
    ASSERT_EQ(total, static_cast<int64_t>(flux));
  }
}

TEST(FluxCutter, EndsPiecesAtTheFloorOfRunningSums) {
  Random random(10);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const uint32_t flux = of_any_length(random) >> 1;
    const uint32_t phase = random.bits() >> 12;
    FluxCutter cutter(Flux::from_raw(static_cast<int32_t>(flux)), phase);
    uint32_t sum = 0;
    uint32_t below = 0;
    while (sum < kRowOne) {
      const uint32_t step = random.between(1, kRowOne / 2);
      const uint32_t part = step < kRowOne - sum ? step : kRowOne - sum;
      sum += part;
      const uint32_t end = floor_of_product(flux, sum, phase);
      ASSERT_EQ(static_cast<uint32_t>(cutter.cut(part).raw), end - below);
      below = end;
    }
    ASSERT_EQ(below, flux);
  }
}

TEST(FluxCutter, IsOddInTheFlux) {
  Random random(11);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const int32_t flux = signed_flux(random);
    const uint32_t phase = random.bits() >> 12;
    const uint32_t part = random.bits() >> random.between(12, 30);
    FluxCutter lent(Flux::from_raw(-flux), phase);
    FluxCutter given(Flux::from_raw(flux), phase);
    ASSERT_EQ(lent.cut(part).raw, -given.cut(part).raw);
  }
}

// |flux - short| < flux / 2048, in 32 bits: 2048 = 2^11.
TEST(ShortFlux, RoundsDownByLessThanOnePartIn2048) {
  Random random(12);
  for (uint16_t i = 0; i < kRounds; ++i) {
    const uint32_t flux = of_any_length(random) >> 1;
    const uint32_t kept = long_flux(short_flux(flux));
    ASSERT_LE(kept, flux);
    ASSERT_TRUE(flux < 4096 ? kept == flux : flux - kept <= (flux - 1) >> kShortFluxBits);
    ASSERT_EQ(short_flux(kept), short_flux(flux));
  }
  EXPECT_EQ(long_flux(short_flux(static_cast<uint32_t>(kMostFlux))), 0x7ff80000u);
}

TEST(Fraction, RoundsDownInUq032) {
  EXPECT_EQ(fraction(1, 2).raw, 0x80000000u);
  EXPECT_EQ(fraction(1, 3).raw, 0x55555555u);
  EXPECT_EQ(fraction(999, 1000).raw, 0xffbe76c8u);  // 2^32 - 4294967.296
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

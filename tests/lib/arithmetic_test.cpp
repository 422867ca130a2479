// SPDX-License-Identifier: MIT
#include "lib/fixed/arithmetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/fixed/vec3.h"
#include "lib/form_factor/row.h"
#include "lib/transport/shooting.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

constexpr std::int32_t kMostFlux = 2147483647;

TEST(Arithmetic, RightShiftOfNegativesIsArithmetic) {
  for (int shift = 0; shift < 31; ++shift) {
    for (const std::int32_t a : {-1, -2, -3, -1000001, -kMostFlux - 1}) {
      EXPECT_EQ(floor_shift(a, shift), static_cast<std::int32_t>(std::floor(std::ldexp(a, -shift))));
    }
  }
}

TEST(Arithmetic, BitLengthIsOneMoreThanTheFloorOfLog2) {
  EXPECT_EQ(bit_length(0), 0);
  for (int n = 0; n < 32; ++n) {
    const std::uint32_t power = std::uint32_t{1} << n;
    EXPECT_EQ(bit_length(power), n + 1);
    EXPECT_EQ(bit_length(power | (power - 1)), n + 1);
  }
}

TEST(Arithmetic, MagnitudeOfTheSmallestIntegerIsTwoToThe31) {
  EXPECT_EQ(magnitude(-kMostFlux - 1), 0x80000000u);
  EXPECT_EQ(magnitude(-5), 5u);
  EXPECT_EQ(magnitude(kMostFlux), 0x7fffffffu);
}

TEST(Arithmetic, MulHighIsTheUpperHalfOfTheProduct) {
  EXPECT_EQ(mul_high(0xffffffffu, 0xffffffffu), 0xfffffffeu);
  EXPECT_EQ(mul_high(0x80000000u, 6), 3u);
  EXPECT_EQ(mul_high(0xffffffffu, 1), 0u);
}

TEST(Arithmetic, FluxBelowIsZeroAtTheStartAndTheWholeAtTheEnd) {
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const std::uint32_t flux = random.bits() >> random.between(1, 31);
    const std::uint32_t phase = random.bits() >> 12;
    ASSERT_EQ(flux_below(flux, 0, phase), 0u);
    ASSERT_EQ(flux_below(flux, kRowOne, phase), flux);
  }
}

TEST(Arithmetic, FluxBelowIsTheExactPartWithinOneUnit) {
  Random random(7);
  for (int i = 0; i < 100000; ++i) {
    const std::uint32_t flux = random.bits() >> random.between(1, 31);
    const std::uint32_t sum = random.bits() >> 12, phase = random.bits() >> 12;
    const double exact = static_cast<double>(flux) * sum / kRowOne;
    ASSERT_LT(std::abs(flux_below(flux, sum, phase) - exact), 1.0);
    ASSERT_GE(flux_below(flux, sum + 1, phase), flux_below(flux, sum, phase));
  }
}

TEST(Arithmetic, BlockNormaliseScalesTheLargestComponentIntoItsBits) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = {random.between(-1000000, 1000000), random.between(-300, 300), random.between(-5, 5)};
    const Vec3 b = block_normalise(a, 14);
    const double scale = static_cast<double>(b.x) / (a.x == 0 ? 1 : a.x);
    ASSERT_LE(max_magnitude(b), 1u << 14);
    ASSERT_GE(max_magnitude(b), max_magnitude(a) == 0 ? 0u : (1u << 13));
    if (std::abs(a.x) > 300) {
      ASSERT_NEAR(b.y, a.y * scale, 1.0);
    }
  }
  EXPECT_EQ(max_magnitude(block_normalise({0, 0, 0}, 14)), 0u);
}

TEST(Reflect, NeverExceedsWhatWasReceived) {
  Random random(3);
  for (int i = 0; i < 100000; ++i) {
    const Flux received = Flux::from_raw(static_cast<std::int32_t>(random.bits() >> 1));
    const Flux reflected = reflect(Reflectance::from_raw(random.bits()), received);
    ASSERT_GE(reflected.raw, 0);
    ASSERT_LE(reflected.raw, received.raw);
  }
  EXPECT_EQ(reflect(Reflectance::from_raw(0xffffffffu), Flux::from_raw(kMostFlux)).raw, kMostFlux - 1);
}

TEST(Reflect, IsOddInWhatWasReceived) {
  Random random(4);
  for (int i = 0; i < 100000; ++i) {
    const auto raw = static_cast<std::int32_t>(random.bits() >> 1);
    const Reflectance reflectance = Reflectance::from_raw(random.bits());
    ASSERT_EQ(reflect(reflectance, Flux::from_raw(-raw)).raw, -reflect(reflectance, Flux::from_raw(raw)).raw);
  }
}

TEST(ShareOf, PartsAddUpToTheWhole) {
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const Flux amount = Flux::from_raw(static_cast<std::int32_t>(random.bits()) / random.between(2, 1000));
    std::int64_t total = 0;
    const std::uint32_t phase = random.bits() >> 12;
    std::uint32_t sum = 0;
    while (sum < kRowOne) {
      const std::uint32_t next =
          std::min(kRowOne, sum + static_cast<std::uint32_t>(random.between(0, 200000)));
      const Flux part = share_of(amount, sum, next, phase);
      ASSERT_TRUE(part.raw == 0 || (part.raw < 0) == (amount.raw < 0));
      total += part.raw;
      sum = next;
    }
    ASSERT_EQ(total, amount.raw);
  }
}

TEST(ShareOf, IsTheSameForLentFlux) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const auto raw = static_cast<std::int32_t>(random.bits() >> 2);
    const auto one = static_cast<int>(kRowOne);
    const int a = random.between(0, one), b = random.between(a, one);
    const auto begin = static_cast<std::uint32_t>(a), end = static_cast<std::uint32_t>(b);
    const std::uint32_t phase = random.bits() >> 12;
    ASSERT_EQ(share_of(Flux::from_raw(-raw), begin, end, phase).raw,
              -share_of(Flux::from_raw(raw), begin, end, phase).raw);
  }
}

TEST(Fraction, RoundsDownInUq032) {
  EXPECT_EQ(fraction(1, 2).raw, 0x80000000u);
  EXPECT_EQ(fraction(1, 3).raw, 0x55555555u);
  EXPECT_EQ(fraction(999, 1000).raw, static_cast<std::uint32_t>(std::floor(std::ldexp(0.999, 32))));
}

}  // namespace
}  // namespace fixrad::host

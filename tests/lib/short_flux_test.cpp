// SPDX-License-Identifier: MIT
#include "lib/fixed/short_flux.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kLargest = 0x7fffffffu;
constexpr std::uint32_t kExactBelow = 1u << 12;

std::uint32_t rounded(std::uint32_t flux) {
  return long_flux(short_flux(flux));
}

// All short ones, both ends of every exponent and its middle with their neighbours, and two million drawn
// ones of every length.
std::vector<std::uint32_t> samples() {
  std::vector<std::uint32_t> all;
  for (std::uint32_t flux = 0; flux < 1u << 14; ++flux) {
    all.push_back(flux);
  }
  for (int bits = 1; bits < 31; ++bits) {
    for (const std::uint32_t edge : {1u << bits, 3u << (bits - 1)}) {
      for (const std::uint32_t flux : {edge - 1, edge, edge + 1}) {
        all.push_back(flux & kLargest);
      }
    }
  }
  all.push_back(kLargest);
  Random random(1);
  for (int i = 0; i < 2000000; ++i) {
    all.push_back((random.bits() & kLargest) >> (i % 31));
  }
  return all;
}

TEST(ShortFlux, RoundsDownByLessThanOnePartIn2048) {
  for (const std::uint32_t flux : samples()) {
    ASSERT_LE(rounded(flux), flux);
    ASSERT_LT(std::uint64_t{2048} * (flux - rounded(flux)), std::max(flux, 1u)) << flux;
  }
}

TEST(ShortFlux, IsExactBelowFourThousandAndNinetySix) {
  for (std::uint32_t flux = 0; flux < kExactBelow; ++flux) {
    ASSERT_EQ(rounded(flux), flux);
  }
  EXPECT_EQ(rounded(kExactBelow), kExactBelow);
  EXPECT_EQ(rounded(kExactBelow + 1), kExactBelow);
}

TEST(ShortFlux, KeepsWhatItHasRounded) {
  for (const std::uint32_t flux : samples()) {
    ASSERT_EQ(short_flux(rounded(flux)), short_flux(flux)) << flux;
  }
}

// Every pattern up to that of the largest flux stands for a flux of its own, in rising order: nothing is
// wasted, and comparing patterns compares fluxes.
TEST(ShortFlux, ComesBackFromEveryPatternInRisingOrder) {
  const std::uint16_t last = short_flux(kLargest);
  EXPECT_EQ(last >> kShortFluxBits, 20) << "the exponent of 31 bits";
  std::uint32_t before = 0;
  for (std::uint32_t pattern = 0; pattern <= last; ++pattern) {
    const std::uint32_t flux = long_flux(static_cast<std::uint16_t>(pattern));
    ASSERT_EQ(short_flux(flux), pattern);
    if (pattern > 0) {
      ASSERT_GT(flux, before);
      ASSERT_EQ(rounded(flux - 1), before) << "the flux just below is rounded to the pattern before";
    }
    before = flux;
  }
}

TEST(ShortFlux, IsMonotone) {
  Random random(2);
  for (int i = 0; i < 200000; ++i) {
    const std::uint32_t a = (random.bits() & kLargest) >> (i % 31), b = a - random.bits() % (a / 1000 + 1);
    ASSERT_GE(short_flux(a), short_flux(b)) << a << ' ' << b;
  }
}

}  // namespace
}  // namespace fixrad::host

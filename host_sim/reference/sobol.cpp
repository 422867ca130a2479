// SPDX-License-Identifier: MIT
#include "host_sim/reference/sobol.h"

#include "host_sim/reference/counter_random.h"

namespace fixrad::host {
namespace {

constexpr std::size_t kBits = 32;
constexpr std::uint64_t kScrambleSeed = 0x6f77656e736f626fU;

using Directions = std::array<std::uint32_t, kBits>;  // for digit k of the index, from the lowest

/// A primitive polynomial over GF(2), x^degree + ... + 1 with the coefficients between as bits, and the first
/// direction numbers.
struct Polynomial {
  std::size_t degree;
  std::uint32_t middle;
  std::array<std::uint32_t, 5> first;
};

/// Dimensions 2 to 10 of new-joe-kuo-6.21201; the first has no polynomial.
constexpr std::array<Polynomial, kSobolDimensions - 1> kPolynomials{{{1, 0, {1}},
                                                                     {2, 1, {1, 3}},
                                                                     {3, 1, {1, 3, 1}},
                                                                     {3, 2, {1, 1, 1}},
                                                                     {4, 1, {1, 1, 3, 3}},
                                                                     {4, 4, {1, 3, 5, 13}},
                                                                     {5, 2, {1, 1, 5, 5, 17}},
                                                                     {5, 4, {1, 1, 5, 5, 5}},
                                                                     {5, 7, {1, 1, 7, 11, 19}}}};

Directions directions_of(const Polynomial& polynomial) {
  Directions v{};
  const std::size_t s = polynomial.degree;
  for (std::size_t k = 0; k < kBits; ++k) {
    if (k < s) {
      v[k] = polynomial.first[k] << (kBits - 1 - k);
      continue;
    }
    v[k] = v[k - s] ^ (v[k - s] >> s);
    for (std::size_t j = 1; j < s; ++j) {
      v[k] ^= ((polynomial.middle >> (s - 1 - j)) & 1U) != 0 ? v[k - j] : 0;
    }
  }
  return v;
}

std::array<Directions, kSobolDimensions> all_directions() {
  std::array<Directions, kSobolDimensions> all{};
  for (std::size_t k = 0; k < kBits; ++k) {
    all[0][k] = 1U << (kBits - 1 - k);
  }
  for (std::size_t d = 1; d < kSobolDimensions; ++d) {
    all[d] = directions_of(kPolynomials[d - 1]);
  }
  return all;
}

std::uint32_t reverse_bits(std::uint32_t x) {
  x = ((x >> 1U) & 0x55555555U) | ((x & 0x55555555U) << 1U);
  x = ((x >> 2U) & 0x33333333U) | ((x & 0x33333333U) << 2U);
  x = ((x >> 4U) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4U);
  x = ((x >> 8U) & 0x00ff00ffU) | ((x & 0x00ff00ffU) << 8U);
  return (x >> 16U) | (x << 16U);
}

/// Flips each digit by a hash of the digits above it: a nested uniform scramble (constants of N. Vegdahl's
/// hash). A product carries upwards only, hence the digits are turned round before and after.
std::uint32_t scramble(std::uint32_t digits, std::uint32_t seed) {
  std::uint32_t x = reverse_bits(digits);
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16U) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return reverse_bits(x);
}

std::size_t lowest_zero(std::uint32_t index) {
  std::size_t k = 0;
  while ((index & 1U) != 0) {
    index >>= 1U;
    ++k;
  }
  return k;
}

}  // namespace

ScrambledSobol::ScrambledSobol(std::uint64_t seed) {
  CounterRandom random(kScrambleSeed, seed, 0);
  for (std::uint32_t& value : seeds_) {
    value = static_cast<std::uint32_t>(random.next_bits() >> 32U);
  }
}

std::array<double, kSobolDimensions> ScrambledSobol::next() {
  static const std::array<Directions, kSobolDimensions> kDirections = all_directions();
  std::array<double, kSobolDimensions> point{};
  const std::size_t digit = lowest_zero(index_++) % kBits;
  for (std::size_t d = 0; d < kSobolDimensions; ++d) {
    point[d] = scramble(digits_[d], seeds_[d]) * 0x1p-32;
    digits_[d] ^= kDirections[d][digit];
  }
  return point;
}

}  // namespace fixrad::host

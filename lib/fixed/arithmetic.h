// SPDX-License-Identifier: MIT
#pragma once

#include <limits.h>
#include <stdint.h>

#include "lib/fixed/q.h"

namespace fixrad {

/// Upper half of a 32 x 32 -> 64-bit product.
inline uint32_t mul_high(uint32_t a, uint32_t b) {
  return static_cast<uint32_t>((static_cast<uint64_t>(a) * b) >> 32);
}

/// |a| as an unsigned number, INT32_MIN included.
inline uint32_t magnitude(int32_t a) {
  return a < 0 ? 0u - static_cast<uint32_t>(a) : static_cast<uint32_t>(a);
}

/// Number of bits that `a` needs; 0 for 0.
inline int bit_length(uint32_t a) {
  // unsigned long has 32 bits or more on every target, unsigned int only 16 on some.
  return a == 0 ? 0 : static_cast<int>(sizeof(unsigned long) * CHAR_BIT) - __builtin_clzl(a);
}

/// Reflected part of all that was received: UQ0.32 x flux -> 64 bits -> truncated towards zero -> flux.
/// Cannot overflow, since reflectance < 1; odd in `received`, so borrowed light is returned to the last unit.
inline Flux reflect(Reflectance reflectance, Flux received) {
  const uint32_t part = mul_high(reflectance.raw, magnitude(received.raw));
  return Flux::from_raw(received.raw < 0 ? -static_cast<int32_t>(part) : static_cast<int32_t>(part));
}

/// floor((flux * sum + phase) / 2^20) for flux < 2^31, sum <= 2^20, phase < 2^20: 64 bits -> below 2^31 + 1.
inline uint32_t flux_below(uint32_t flux, uint32_t sum, uint32_t phase) {
  return static_cast<uint32_t>((static_cast<uint64_t>(flux) * sum + phase) >> 20);
}

/// a / 2^shift towards minus infinity. C++17 leaves >> of a negative number to the compiler; every compiler
/// that the project is built with shifts arithmetically, which tests/lib asserts on each target.
inline int32_t floor_shift(int32_t a, int shift) {
  return a >> shift;
}

}  // namespace fixrad

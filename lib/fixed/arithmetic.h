// SPDX-License-Identifier: MIT
#pragma once

#include <limits.h>
#include <stdint.h>

#include "lib/fixed/checked.h"
#include "lib/fixed/product.h"
#include "lib/fixed/q.h"

namespace fixrad {

/// |a| as an unsigned number, INT32_MIN included.
FIXRAD_MODULO inline uint32_t magnitude(int32_t a) {
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

/// How much more of `received` + `share` is reflected than of `received`: the difference of two reflect(),
/// with one wide product less where both fluxes have one sign. There the low words of the two products tell
/// whether the sum carries.
FIXRAD_MODULO inline Flux reflect_more(Reflectance reflectance, Flux received, Flux share) {
  if ((received.raw ^ share.raw) < 0) {
    return reflect(reflectance, received + share) - reflect(reflectance, received);
  }
  const uint64_t more = wide_product(reflectance.raw, magnitude(share.raw));
  const uint32_t low = reflectance.raw * magnitude(received.raw);
  const uint32_t carry = static_cast<uint32_t>(more) > ~low ? 1 : 0;
  const int32_t part = static_cast<int32_t>(static_cast<uint32_t>(more >> 32) + carry);
  return Flux::from_raw(share.raw < 0 ? -part : part);
}

/// a / 2^shift towards minus infinity. C++17 leaves >> of a negative number to the compiler; every compiler
/// that the project is built with shifts arithmetically, which tests/lib asserts on each target.
inline int32_t floor_shift(int32_t a, int shift) {
  return a >> shift;  // cppcheck-suppress shiftNegativeLHS ; as above
}

/// a / 2^shift to the nearest integer, shift > 0; needs a < 2^31 - 2^(shift - 1).
inline int32_t rounded_shift(int32_t a, int shift) {
  return floor_shift(a + (static_cast<int32_t>(1) << (shift - 1)), shift);
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/arithmetic.h"

namespace fixrad {

/// Three integers in one format; which one, the user says.
struct Vec3 {
  int32_t x, y, z;
};

inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// a . b; the caller proves that it fits 32 bits.
inline int32_t dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a x b; components below 2^14 give results below 2^29.
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Largest magnitude of the three components.
inline uint32_t max_magnitude(Vec3 a) {
  uint32_t m = magnitude(a.x);
  m = magnitude(a.y) > m ? magnitude(a.y) : m;
  return magnitude(a.z) > m ? magnitude(a.z) : m;
}

/// a / 2^shift, each component rounded to nearest (shift >= 0) or scaled up exactly (shift < 0).
inline Vec3 scale_down(Vec3 a, int shift) {
  if (shift <= 0) {
    const int32_t factor = static_cast<int32_t>(1) << -shift;
    return {a.x * factor, a.y * factor, a.z * factor};
  }
  const int32_t half = static_cast<int32_t>(1) << (shift - 1);
  return {floor_shift(a.x + half, shift), floor_shift(a.y + half, shift), floor_shift(a.z + half, shift)};
}

/// `a` scaled by a power of two so that its largest component has `bits` bits or one less than that before
/// rounding: every component ends in [-2^bits, 2^bits]. Needs |a| < 2^31 - 2^30 / 2^bits. Zero stays zero.
inline Vec3 block_normalise(Vec3 a, int bits) {
  const uint32_t m = max_magnitude(a);
  return m == 0 ? a : scale_down(a, bit_length(m) - bits);
}

}  // namespace fixrad

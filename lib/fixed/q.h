// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace fixrad {

/// A fixed-point number: `Raw` is an integer type, the value is raw / 2^FracBits.
///
/// The binary point is part of the type: adding or comparing two different formats, assigning one to another,
/// or mixing with int or a floating type does not compile (tests/nocompile lists it). Sums stay in their
/// format and the caller proves their range (docs/numbers.md); products name the format of their result.
template <class Raw, int FracBits>
struct Q {
  static_assert(FracBits >= 0 && FracBits <= static_cast<int>(sizeof(Raw) * 8), "no such binary point");
  using raw_type = Raw;
  static constexpr int frac_bits = FracBits;

  Raw raw;

  /// The number whose bits are `bits`.
  static constexpr Q from_raw(Raw bits) { return Q{bits}; }

  friend constexpr Q operator+(Q a, Q b) { return Q{static_cast<Raw>(a.raw + b.raw)}; }
  friend constexpr Q operator-(Q a, Q b) { return Q{static_cast<Raw>(a.raw - b.raw)}; }
  constexpr Q& operator+=(Q b) { return *this = *this + b; }
  constexpr Q& operator-=(Q b) { return *this = *this - b; }
  friend constexpr bool operator==(Q a, Q b) { return a.raw == b.raw; }
  friend constexpr bool operator!=(Q a, Q b) { return a.raw != b.raw; }
  friend constexpr bool operator<(Q a, Q b) { return a.raw < b.raw; }
  friend constexpr bool operator<=(Q a, Q b) { return a.raw <= b.raw; }
  friend constexpr bool operator>(Q a, Q b) { return a.raw > b.raw; }
  friend constexpr bool operator>=(Q a, Q b) { return a.raw >= b.raw; }
};

/// Diffuse reflectance: UQ0.32, [0, 1). 1 cannot be written, so no surface can create light.
using Reflectance = Q<uint32_t, 32>;

/// A flux in the scene's flux unit: Q31.0, signed because overshooting lends flux. The unit leaves headroom
/// for 1/(1 - reflectance), see docs/numbers.md.
using Flux = Q<int32_t, 0>;

/// An area in 1/8 square grid units: UQ29.3.
using Area = Q<uint32_t, 3>;

/// A radiosity in the scene's radiosity unit: UQ32.0.
using Radiosity = Q<uint32_t, 0>;

}  // namespace fixrad

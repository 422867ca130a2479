// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/vec3.h"

namespace fixrad {

/// One in the unit of directions and of the ratios made of them: Q1.30.
constexpr int kArcBits = 30;
constexpr int32_t kArcOne = 1l << kArcBits;

/// Angles: Q3.28, radians; pi is 843,314,857.
constexpr int kAngleBits = 28;

/// 1/sqrt(a): UQ2.30, for `a` in UQ0.32 from 1/4 to below 1. Error below 2^-27. Newton's iteration from a
/// straight line. Cost: 12 wide products.
uint32_t inverse_root(uint32_t a);

/// The direction of `a`, components Q1.30, each off by less than 2^-26. Needs |components| < 2^31 - 1;
/// zero stays zero. Cost: 18 wide products, no division.
Vec3 unit_vector(Vec3 a);

/// acos(c) / sqrt(1 - c^2), the angle over its sine, Q1.30, for c = cosine in [0, kArcOne]: from pi/2 down
/// to 1. Error below 2^-24. It is smooth where acos itself is not, at c = 1, so small angles keep all their
/// digits. A polynomial of degree 9 in 1 - c. Cost: 9 wide products.
int32_t angle_over_sine(int32_t cosine);

/// n . (a x b) / |a x b| times the angle between a and b, Q3.28: what the edge from `a` to `b` of a contour
/// gives to Lambert's formula. All three are unit vectors, Q1.30. Odd in (a, b) up to its rounding; 0 where a
/// and b are parallel or opposite. Error below 2^-23 times the sine of that angle, plus 2^-25; more than
/// 2^-18 only for angles within 2^-7 of pi. Cost: 13 to 50 wide products.
int32_t edge_term(const Vec3& a, const Vec3& b, const Vec3& n);

}  // namespace fixrad

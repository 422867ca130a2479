// SPDX-License-Identifier: MIT
#include "lib/form_factor/arc.h"

#include "lib/fixed/flash.h"

namespace fixrad {
namespace {

// Interpolates acos(1 - t) / sqrt(t (2 - t)) at the ten Chebyshev points of [0, 1]; off by 2.0e-8 at most.
constexpr int kArcDegree = 9;
constexpr FIXRAD_IN_FLASH int32_t kArcCoefficients[kArcDegree + 1] = {
    1073741813, 357916140, 143093892, 62253190, 21650382, 32275794, -36027257, 54734804, -34995060, 11985992};

// The best straight line for 1/sqrt on [1/4, 1], 8.8 % off: 2.13 - 1.21 a, UQ2.30.
constexpr uint32_t kSeedAtZero = 2287070085ul;
constexpr uint32_t kSeedSlope = 1299227607ul;
constexpr int kNewtonSteps = 4;

int32_t scaled_product(int32_t a, int32_t b, int shift) {
  return static_cast<int32_t>((static_cast<int64_t>(a) * b) >> shift);
}

int32_t unit_dot(const Vec3& a, const Vec3& b) {
  const int64_t sum =
      static_cast<int64_t>(a.x) * b.x + static_cast<int64_t>(a.y) * b.y + static_cast<int64_t>(a.z) * b.z;
  return static_cast<int32_t>(sum >> kArcBits);
}

int32_t determinant(int32_t a, int32_t b, int32_t c, int32_t d) {
  return static_cast<int32_t>((static_cast<int64_t>(a) * d - static_cast<int64_t>(b) * c) >> kArcBits);
}

Vec3 unit_cross(const Vec3& a, const Vec3& b) {
  return {determinant(a.y, a.z, b.y, b.z), determinant(a.z, a.x, b.z, b.x), determinant(a.x, a.y, b.x, b.y)};
}

// The bisector of opposite directions is what rounding leaves of their sum: it may point anywhere.
int32_t acute_term(const Vec3& a, const Vec3& b, const Vec3& n) {
  const int32_t sine = unit_dot(unit_cross(a, b), n);
  const int32_t cosine = unit_dot(a, b);
  return scaled_product(angle_over_sine(cosine > 0 ? cosine : 0), sine, 2 * kArcBits - kAngleBits);
}

}  // namespace

// y (3 - a y^2) / 2 squares the error, times 3/2: 0.088, 0.012, 2e-4, 7e-8, 7e-15, and below 2^-27 what four
// steps round.
uint32_t inverse_root(uint32_t a) {
  uint32_t y = kSeedAtZero - mul_high(kSeedSlope, a);
  for (int step = 0; step < kNewtonSteps; ++step) {
    const uint32_t square = static_cast<uint32_t>(wide_product(y, y) >> 31);  // UQ3.29, at most 4.05
    const uint32_t rest = 3ul * (1ul << 29) - mul_high(a, square);            // UQ3.29
    y = static_cast<uint32_t>(wide_product(y, rest) >> kArcBits);
  }
  return y;
}

Vec3 unit_vector(Vec3 a) {
  const uint32_t m = max_magnitude(a);
  if (m == 0) {
    return a;
  }
  const Vec3 v = scale_down(a, bit_length(m) - kArcBits);
  const uint64_t square = wide_product(magnitude(v.x), magnitude(v.x)) +
                          wide_product(magnitude(v.y), magnitude(v.y)) +
                          wide_product(magnitude(v.z), magnitude(v.z));  // 2^58 .. 3 * 2^60
  const int half_bits = (square >> 60) != 0 ? 31 : 30;
  const uint32_t root = inverse_root(static_cast<uint32_t>(square >> (2 * half_bits - 32)));
  const int64_t factor = root;
  return {static_cast<int32_t>((v.x * factor) >> half_bits),
          static_cast<int32_t>((v.y * factor) >> half_bits),
          static_cast<int32_t>((v.z * factor) >> half_bits)};
}

int32_t angle_over_sine(int32_t cosine) {
  const int32_t t = cosine < kArcOne ? kArcOne - cosine : 0;
  int32_t sum = flash_read(kArcCoefficients, kArcDegree);
  for (int i = kArcDegree; i-- > 0;) {
    sum = flash_read(kArcCoefficients, static_cast<unsigned>(i)) + scaled_product(sum, t, kArcBits);
  }
  return sum;
}

// Beyond a right angle the bisector m halves the edge into two equal ones in one plane, a x m = (a x b) / |a
// + b|.
int32_t edge_term(const Vec3& a, const Vec3& b, const Vec3& n) {
  if (unit_dot(a, b) >= 0) {
    return acute_term(a, b, n);
  }
  const Vec3 sum = {a.x + b.x, a.y + b.y, a.z + b.z};
  return 2 * acute_term(a, unit_vector(sum), n);
}

}  // namespace fixrad

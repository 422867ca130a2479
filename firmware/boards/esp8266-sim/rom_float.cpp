// SPDX-License-Identifier: MIT
// Single-precision routines of the ESP8266's ROM that its libgcc lacks: IEEE 754 with subnormals, infinities
// and quiet NaNs, rounded to nearest, ties to even. They work on bits; nothing here may use float arithmetic.
// Only programs that compute in float link them.

#include <stdint.h>

namespace {

constexpr uint32_t kSign = 0x80000000u;
constexpr uint32_t kInfinity = 0x7f800000u;
constexpr uint32_t kQuietNan = 0x7fc00000u;
constexpr uint32_t kLeadingBit = 0x00800000u;
constexpr uint32_t kFraction = 0x007fffffu;
constexpr int kFractionBits = 23;

inline uint32_t bits_of(float value) {
  union {
    float value;
    uint32_t bits;
  } both = {value};
  return both.bits;
}

inline float float_of(uint32_t bits) {
  union {
    uint32_t bits;
    float value;
  } both = {bits};
  return both.value;
}

// Shifts right; what falls off leaves its trace in the lowest bit.
inline uint32_t shift_sticky(uint32_t value, int count) {
  if (count > 31) {
    return value != 0 ? 1u : 0u;
  }
  return count == 0 ? value : value >> count | ((value << (32 - count)) != 0 ? 1u : 0u);
}

// The float of a significand with its leading bit at 30 and seven bits to round, times 2^(exponent - 157);
// exponent may lie outside the range of a float. significand 0 is zero.
inline uint32_t round_and_pack(uint32_t sign, int exponent, uint32_t significand) {
  if (exponent >= 255) {
    return sign | kInfinity;
  }
  if (exponent <= 0) {
    significand = shift_sticky(significand, 1 - exponent);
    exponent = 0;
  }
  const uint32_t rest = significand & 0x7fu;
  significand = (significand + 0x40u) >> 7;
  if (rest == 0x40u) {
    significand &= ~1u;
  }
  // A carry into the leading bit raises the exponent, also from subnormal to normal, and from the largest
  // number to infinity.
  const uint32_t hidden = exponent == 0 ? 0u : kLeadingBit;
  return sign | ((static_cast<uint32_t>(exponent) << kFractionBits) + (significand - hidden));
}

inline int leading_zeros(uint32_t value) {
  return __builtin_clz(value);
}

// Of finite numbers, |a| >= |b|.
uint32_t add_ordered(uint32_t a, uint32_t b) {
  int exponent_a = static_cast<int>(a >> kFractionBits & 0xffu),
      exponent_b = static_cast<int>(b >> kFractionBits & 0xffu);
  uint32_t fa = (a & kFraction) << 6, fb = (b & kFraction) << 6;
  fa |= exponent_a != 0 ? kLeadingBit << 6 : 0u;
  fb |= exponent_b != 0 ? kLeadingBit << 6 : 0u;
  exponent_a += exponent_a == 0 ? 1 : 0;
  exponent_b += exponent_b == 0 ? 1 : 0;
  fb = shift_sticky(fb, exponent_a - exponent_b);
  const uint32_t sum = ((a ^ b) & kSign) != 0 ? fa - fb : fa + fb;  // leading bit at 30 or below
  if (sum == 0) {
    return a & b & kSign;
  }
  const int shift = leading_zeros(sum) - 1;
  return round_and_pack(a & kSign, exponent_a + 1 - shift, sum << shift);
}

uint32_t add(uint32_t a, uint32_t b) {
  const uint32_t magnitude_a = a & ~kSign, magnitude_b = b & ~kSign;
  if (magnitude_a < magnitude_b) {
    return add(b, a);
  }
  if (magnitude_a >= kInfinity) {
    const bool is_nan = magnitude_a > kInfinity || (magnitude_b == kInfinity && a != b);
    return is_nan ? kQuietNan : a;
  }
  return add_ordered(a, b);
}

struct Unpacked {
  int exponent;
  uint32_t significand;  // leading bit at 23
};

inline Unpacked unpack(uint32_t magnitude) {
  if (magnitude >= kLeadingBit) {
    return {static_cast<int>(magnitude >> kFractionBits), (magnitude & kFraction) | kLeadingBit};
  }
  const int shift = leading_zeros(magnitude) - 8;
  return {1 - shift, magnitude << shift};
}

uint32_t multiply(uint32_t a, uint32_t b) {
  const uint32_t sign = (a ^ b) & kSign;
  a &= ~kSign;
  b &= ~kSign;
  if (a >= kInfinity || b >= kInfinity) {
    const bool is_nan = a > kInfinity || b > kInfinity || a == 0 || b == 0;
    return is_nan ? kQuietNan : sign | kInfinity;
  }
  if (a == 0 || b == 0) {
    return sign;
  }
  const Unpacked ua = unpack(a), ub = unpack(b);
  // Both with the leading bit at 31 but for a's one below: the product's leading bit is bit 62 or 61.
  const uint32_t x = ua.significand << 7, y = ub.significand << 8;
  const uint32_t xl = x & 0xffffu, xh = x >> 16, yl = y & 0xffffu, yh = y >> 16;
  const uint32_t low = xl * yl;
  const uint32_t cross = xh * yl + (low >> 16);
  const uint32_t middle = xl * yh + (cross & 0xffffu);
  uint32_t high = xh * yh + (cross >> 16) + (middle >> 16);
  high |= ((middle << 16) | (low & 0xffffu)) != 0 ? 1u : 0u;
  const int shift = leading_zeros(high) - 1;
  return round_and_pack(sign, ua.exponent + ub.exponent - 126 - shift, high << shift);
}

uint32_t from_magnitude(uint32_t sign, uint32_t magnitude) {
  if (magnitude == 0) {
    return 0;
  }
  const int zeros = leading_zeros(magnitude);
  const uint32_t significand = zeros == 0 ? shift_sticky(magnitude, 1) : magnitude << (zeros - 1);
  return round_and_pack(sign, 158 - zeros, significand);
}

}  // namespace

extern "C" {
float __addsf3(float a, float b);
float __subsf3(float a, float b);
float __mulsf3(float a, float b);
float __floatsisf(int32_t value);
float __floatunsisf(uint32_t value);
uint32_t __fixunssfsi(float value);
}

float __addsf3(float a, float b) {
  return float_of(add(bits_of(a), bits_of(b)));
}

float __subsf3(float a, float b) {
  return float_of(add(bits_of(a), bits_of(b) ^ kSign));
}

float __mulsf3(float a, float b) {
  return float_of(multiply(bits_of(a), bits_of(b)));
}

float __floatsisf(int32_t value) {
  const auto bits = static_cast<uint32_t>(value);
  return float_of(from_magnitude(bits & kSign, value < 0 ? 0u - bits : bits));
}

float __floatunsisf(uint32_t value) {
  return float_of(from_magnitude(0, value));
}

uint32_t __fixunssfsi(float value) {
  const uint32_t bits = bits_of(value);
  const int exponent = static_cast<int>(bits >> kFractionBits & 0xffu) - 127;
  if ((bits & kSign) != 0 || exponent < 0) {
    return 0;
  }
  if (exponent > 31) {
    return UINT32_MAX;
  }
  const uint32_t significand = (bits & kFraction) | kLeadingBit;
  return exponent >= kFractionBits ? significand << (exponent - kFractionBits)
                                   : significand >> (kFractionBits - exponent);
}

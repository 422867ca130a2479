// SPDX-License-Identifier: MIT
// Integer routines that the compiler calls and the ESP8266 has in its ROM, which its libgcc therefore lacks.
// The core has a product of the low 32 bits and a count of leading zeros, no division.

#include <stdint.h>

extern "C" {
uint64_t __muldi3(uint64_t a, uint64_t b);
uint64_t __umulsidi3(uint32_t a, uint32_t b);
uint32_t __udivsi3(uint32_t n, uint32_t d);
uint32_t __umodsi3(uint32_t n, uint32_t d);
int32_t __divsi3(int32_t n, int32_t d);
uint64_t __udivdi3(uint64_t n, uint64_t d);
uint64_t __umoddi3(uint64_t n, uint64_t d);
int64_t __divdi3(int64_t n, int64_t d);
// libgcc has this one.
uint64_t __udivmoddi4(uint64_t n, uint64_t d, uint64_t* remainder);
}

namespace {

// 32 x 32 -> 64 bits from 16-bit halves; no sum exceeds 32 bits.
inline uint64_t wide_product(uint32_t a, uint32_t b) {
  const uint32_t al = a & 0xffffu, ah = a >> 16, bl = b & 0xffffu, bh = b >> 16;
  const uint32_t low = al * bl;
  const uint32_t cross = ah * bl + (low >> 16);
  const uint32_t middle = al * bh + (cross & 0xffffu);
  const uint32_t high = ah * bh + (cross >> 16) + (middle >> 16);
  return uint64_t{high} << 32 | (middle << 16 | (low & 0xffffu));
}

struct Division {
  uint32_t quotient, remainder;
};

// One step a bit of the quotient, as the divisor is first brought under the leading bit. d > 0.
inline Division divide(uint32_t n, uint32_t d) {
  if (n < d) {
    return {0, n};
  }
  const int steps = __builtin_clz(d) - __builtin_clz(n);
  uint32_t divisor = d << steps, quotient = 0;
  for (int i = 0; i <= steps; ++i) {
    quotient <<= 1;
    if (n >= divisor) {
      n -= divisor;
      quotient |= 1;
    }
    divisor >>= 1;
  }
  return {quotient, n};
}

inline uint32_t magnitude(int32_t value) {
  return value < 0 ? 0u - static_cast<uint32_t>(value) : static_cast<uint32_t>(value);
}
inline uint64_t magnitude(int64_t value) {
  return value < 0 ? uint64_t{0} - static_cast<uint64_t>(value) : static_cast<uint64_t>(value);
}

}  // namespace

uint64_t __muldi3(uint64_t a, uint64_t b) {
  const auto al = static_cast<uint32_t>(a), bl = static_cast<uint32_t>(b);
  const auto ah = static_cast<uint32_t>(a >> 32), bh = static_cast<uint32_t>(b >> 32);
  return wide_product(al, bl) + (uint64_t{al * bh + ah * bl} << 32);
}

uint64_t __umulsidi3(uint32_t a, uint32_t b) {
  return wide_product(a, b);
}

uint32_t __udivsi3(uint32_t n, uint32_t d) {
  return divide(n, d).quotient;
}

uint32_t __umodsi3(uint32_t n, uint32_t d) {
  return divide(n, d).remainder;
}

int32_t __divsi3(int32_t n, int32_t d) {
  const uint32_t quotient = divide(magnitude(n), magnitude(d)).quotient;
  return static_cast<int32_t>((n < 0) != (d < 0) ? 0u - quotient : quotient);
}

uint64_t __udivdi3(uint64_t n, uint64_t d) {
  return __udivmoddi4(n, d, nullptr);
}

uint64_t __umoddi3(uint64_t n, uint64_t d) {
  uint64_t remainder = 0;
  __udivmoddi4(n, d, &remainder);
  return remainder;
}

int64_t __divdi3(int64_t n, int64_t d) {
  const uint64_t quotient = __udivmoddi4(magnitude(n), magnitude(d), nullptr);
  return static_cast<int64_t>((n < 0) != (d < 0) ? uint64_t{0} - quotient : quotient);
}

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

// 32 x 32 -> 64-bit products. A compiler makes one instruction of them where there is one; for AVR it calls a
// routine of 8-bit products. Elsewhere it calls a 64 x 64-bit routine: there a body of 16-bit halves takes
// its place. Both give the same bits, and both are tested on every target.

namespace fixrad {

#if defined(__ARM_ARCH_6M__) || defined(__XTENSA__)
constexpr bool kHasWideProduct = false;
#else
constexpr bool kHasWideProduct = true;
#endif

#if defined(__ARM_ARCH_6M__) || defined(__XTENSA__) || defined(__AVR__)
constexpr bool kHasDivision = false;
#else
constexpr bool kHasDivision = true;
#endif

/// The product as the compiler makes it.
inline uint64_t wide_product_plain(uint32_t a, uint32_t b) {
  return static_cast<uint64_t>(a) * b;
}

/// The product from four of 16-bit halves; the two in the middle are added one after the other, so that no
/// sum passes 32 bits. Two of the four are left out where b has 16 bits, as most shares of a shot have.
inline uint64_t wide_product_halves(uint32_t a, uint32_t b) {
  const uint32_t al = a & 0xffffu, ah = a >> 16, bl = b & 0xffffu, bh = b >> 16;
  const uint32_t low = al * bl;
  const uint32_t cross = ah * bl + (low >> 16);  // below 2^32
  if (bh == 0) {
    return static_cast<uint64_t>(cross >> 16) << 32 | (cross << 16 | (low & 0xffffu));
  }
  const uint32_t middle = al * bh + (cross & 0xffffu);
  const uint32_t high = ah * bh + (cross >> 16) + (middle >> 16);
  return static_cast<uint64_t>(high) << 32 | (middle << 16 | (low & 0xffffu));
}

/// a * b, exactly.
inline uint64_t wide_product(uint32_t a, uint32_t b) {
  return kHasWideProduct ? wide_product_plain(a, b) : wide_product_halves(a, b);
}

/// Upper half of a * b.
inline uint32_t mul_high(uint32_t a, uint32_t b) {
  return static_cast<uint32_t>(wide_product(a, b) >> 32);
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/arithmetic.h"

namespace fixrad {

/// A flux of 0 .. 2^31 - 1 in 16 bits: below 2^11 as it is, else eleven bits after the leading one and five
/// bits that say where that one stands. What the bits cannot tell is for the caller to keep: short_flux()
/// rounds down, by less than 1/2048 of the flux.
constexpr int kShortFluxBits = 11;

FIXRAD_MODULO inline uint32_t long_flux(uint16_t a) {
  const unsigned exponent = a >> kShortFluxBits;
  const uint32_t mantissa = a & ((1u << kShortFluxBits) - 1u);
  return exponent == 0 ? mantissa : (mantissa | static_cast<uint32_t>(1) << kShortFluxBits) << (exponent - 1);
}

inline uint16_t short_flux(uint32_t flux) {
  const int shift = bit_length(flux) - (kShortFluxBits + 1);
  if (shift < 0) {
    return static_cast<uint16_t>(flux);
  }
  // The leading one of the shifted flux raises the exponent by one.
  return static_cast<uint16_t>((static_cast<uint32_t>(shift) << kShortFluxBits) + (flux >> shift));
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/arithmetic.h"
#include "lib/fixed/checked.h"

namespace fixrad {

/// Cuts a whole into pieces along parts of 2^20: piece i ends at floor((whole * sum_i + phase) / 2^20), with
/// sum_i the sum of the parts up to it, so pieces of parts that add up to 2^20 add up to the whole, exactly.
/// Needs whole <= 2^31; the phase (0 .. 2^20 - 1) says how the ends are rounded.
class Cutter {
 public:
  Cutter(uint32_t whole, uint32_t phase) : whole_(whole), rest_(phase) {}

  /// The piece of the next `part` (UQ1.20). What the floor leaves, below 2^20, goes on to the next piece.
  uint32_t cut(uint32_t part) { return part < kNarrowPart ? narrow_piece(part) : wide_piece(part); }

 private:
  // Parts for which the product of each half of the whole and the rest fits 32 bits.
  static constexpr uint32_t kNarrowPart = 1ul << 15;

  uint32_t wide_piece(uint32_t part) {
    const uint64_t product = wide_product(whole_, part) + rest_;
    rest_ = static_cast<uint32_t>(product) & 0xffffful;
    return static_cast<uint32_t>(product >> 20);
  }

  uint32_t narrow_piece(uint32_t part) {
    const uint32_t low = (whole_ & 0xffffu) * part + rest_;
    const uint32_t high = (whole_ >> 16) * part + (low >> 16);
    rest_ = (high & 15u) << 16 | (low & 0xffffu);
    return high >> 4;
  }

  uint32_t whole_;
  uint32_t rest_;
};

/// The same for a flux; odd in it, so that lent flux is cut like given flux.
class FluxCutter {
 public:
  FluxCutter(Flux flux, uint32_t phase) : cutter_(magnitude(flux.raw), phase), is_negative_(flux.raw < 0) {}

  Flux cut(uint32_t part) {
    const int32_t piece = narrow<int32_t>(cutter_.cut(part), Place::piece_of_flux);
    return Flux::from_raw(is_negative_ ? -piece : piece);
  }

 private:
  Cutter cutter_;
  bool is_negative_;
};

}  // namespace fixrad

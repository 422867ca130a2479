// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/table.h"

namespace fixrad {
namespace peer {

/// One pixel of a half row: the sum of the delta form factors from the middle of the row to a position p
/// pixels away from it is intercept + slope p, 2^-20. The same function as the core's table, as the two
/// numbers that a product and a sum need.
struct Segment {
  float intercept, slope;
};

/// The core's delta form factors of one resolution, laid out as there: R/2 rows of R/2 segments for the top,
/// and as many for a side.
struct DeltaTable {
  uint8_t half;  ///< R/2
  const FIXRAD_FLASH Segment* top;
  const FIXRAD_FLASH Segment* side;
};

/// A row of form factors in all, as in the core.
constexpr float kRowOne = 1048576.0f;

/// All tables one after the other: R = 8, 16, 32, of each first the top, then a side.
const FIXRAD_FLASH Segment* delta_segments();

/// Are there tables of R = 2^resolution_log2?
inline bool has_delta_table(uint8_t resolution_log2) {
  return resolution_log2 >= 3 && resolution_log2 <= 5;
}

/// The table of R = 2^resolution_log2, one of those that there are. Addresses are computed, since clang for
/// AVR halves pointers to flash that stand in constants.
inline DeltaTable delta_table(uint8_t resolution_log2) {
  const unsigned half = 1u << (resolution_log2 - 1);
  const unsigned smaller = 2 * (half * half - 16) / 3;  // 2 * 4 * 4 + 2 * 8 * 8 + .. below 2 * half * half
  const FIXRAD_FLASH Segment* top = delta_segments() + smaller;
  return {static_cast<uint8_t>(half), top, top + half * half};
}

/// One row of a side or of the top.
struct DeltaRow {
  const FIXRAD_FLASH Segment* segments;
  uint8_t half;

  /// Sum from the middle of the row to x (-R/2 .. R/2, pixels), 2^-20; negative to the left of the middle.
  float sum_to(float x) const { return __builtin_signbit(x) ? -sum_right(-x) : sum_right(x); }

 private:
  float sum_right(float distance) const {
    const uint8_t pixel = static_cast<uint8_t>(distance);
    const Segment s = read(segments, pixel < half ? pixel : half - 1u);
    return s.intercept + s.slope * distance;
  }
};

/// Row `row` (0 .. R-1, bottom up) of the top, or of a side (R/2 .. R-1).
inline DeltaRow delta_row(const DeltaTable& table, bool is_top, uint8_t row) {
  const unsigned from_middle = row >= table.half ? row - table.half : table.half - 1u - row;
  return {(is_top ? table.top : table.side) + from_middle * table.half, table.half};
}

}  // namespace peer
}  // namespace fixrad

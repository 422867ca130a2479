// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/flash.h"

namespace fixrad {

/// Delta form factors of a hemicube, as running sums along each row (Cohen & Greenberg 1985, "The Hemi-Cube",
/// section 5, equations for the top and side pixels; here integrated over a row instead of summed by pixel).
///
/// Units of 2^-20: top plus four sides sum to exactly 2^20. A row is symmetric about its middle and the top
/// also from row to row, so a table holds R/2 rows of R/2 entries: entry i of row r is the sum from the
/// middle of the row to the i+1-th pixel border. Row 0 is the one next to the middle of the top, or next to
/// the horizon of a side. UQ0.20 in 16 bits: the fullest half row, at R = 8, holds 0.0494 = 51,824 / 2^20.
struct DeltaTable {
  uint8_t resolution_log2;            ///< k, R = 2^k pixels along an edge of the hemicube, 3..7
  const FIXRAD_FLASH uint16_t* top;   ///< [R/2][R/2]
  const FIXRAD_FLASH uint16_t* side;  ///< [R/2][R/2]
};

constexpr int kDeltaSumLog2 = 20;

extern const DeltaTable kDelta8, kDelta16, kDelta32, kDelta64, kDelta128;

/// Positions along a row are counted in 1/4096 of its length, whatever the resolution.
constexpr int kRowLog2 = 12;
constexpr int32_t kRowEnd = 1 << kRowLog2;
constexpr int32_t kRowMiddle = kRowEnd / 2;

/// Sum of the delta form factors of half a row from its middle to `distance` (0..kRowMiddle), 2^-20; linear
/// within a pixel, monotone in `distance`. `half_row` points at R/2 entries.
inline uint32_t half_row_sum(const FIXRAD_FLASH uint16_t* half_row, int resolution_log2, int32_t distance) {
  const int frac_bits = kRowLog2 - resolution_log2;
  const int pixel = static_cast<int>(distance >> frac_bits);
  const uint32_t below = pixel == 0 ? 0u : flash_read(half_row, static_cast<unsigned>(pixel - 1));
  const uint32_t frac = static_cast<uint32_t>(distance) & ((1u << frac_bits) - 1u);
  if (frac == 0) {
    return below;
  }
  const uint32_t above = flash_read(half_row, static_cast<unsigned>(pixel));
  return below + (((above - below) * frac) >> frac_bits);
}

/// One row of a hemicube's side or top.
struct DeltaRow {
  const FIXRAD_FLASH uint16_t* half;
  uint8_t resolution_log2;
  uint32_t half_total;  ///< sum of half the row, 2^-20

  /// Running sum from the left end of the row to x (0..kRowEnd), 2^-20.
  uint32_t sum_to(int32_t x) const {
    return x >= kRowMiddle ? half_total + half_row_sum(half, resolution_log2, x - kRowMiddle)
                           : half_total - half_row_sum(half, resolution_log2, kRowMiddle - x);
  }
};

/// Row `r` (0..R-1, bottom up) of the top, or of a side (R/2..R-1 only: a side ends at the horizon).
inline DeltaRow delta_row(const DeltaTable& table, bool is_top, int r) {
  const int half_size = 1 << (table.resolution_log2 - 1);
  const int from_middle = r >= half_size ? r - half_size : half_size - 1 - r;
  const FIXRAD_FLASH uint16_t* half = (is_top ? table.top : table.side) + from_middle * half_size;
  return {half, table.resolution_log2, flash_read(half, static_cast<unsigned>(half_size - 1))};
}

}  // namespace fixrad

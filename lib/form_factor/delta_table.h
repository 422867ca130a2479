// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/flash.h"

namespace fixrad {

/// Delta form factors of one way to cut the hemisphere into rows, as running sums along each row, in units of
/// 2^-20; all rows sum to exactly 2^20. A row is symmetric about its middle: tables hold the half from the
/// middle to the end, entry i the sum up to the border of the i+1-th of its equal parts.
///
/// Hemicube (Cohen & Greenberg 1985, "The Hemi-Cube", section 5, equations for the top and side pixels; here
/// integrated over a row instead of summed by pixel): R/2 rows of R/2 entries for the top and as many for a
/// side, row 0 next to the middle of the top, or next to the horizon of a side. UQ0.20 in 16 bits: the
/// fullest half row, at R = 8, holds 0.0494 = 51,824 / 2^20.
///
/// Lunes (docs/lunes.md): R half great circles through one axis of the surface, equally spaced in the sine of
/// their angle to the normal. All weigh 1/R, so one row of kLuneParts entries, in units of 1/2^16 of a whole
/// row, serves every row of every R.
struct DeltaTable {
  uint8_t resolution_log2;            ///< k, R = 2^k, 3..7 (lunes: from 2)
  const FIXRAD_FLASH uint16_t* top;   ///< hemicube: [R/2][R/2]; lunes: [kLuneParts]
  const FIXRAD_FLASH uint16_t* side;  ///< hemicube: [R/2][R/2]; lunes: null
  const FIXRAD_FLASH int16_t*
      cosine;  ///< lunes: [R/2], Q11, of a row's angle, from the middle out; hemicube: null
};

constexpr int kDeltaSumLog2 = 20;

extern const FIXRAD_IN_FLASH DeltaTable kDelta8, kDelta16, kDelta32, kDelta64, kDelta128;

/// Lunes of R = 4, 8, .. 128, one after the other.
constexpr int kLuneTables = 6;
extern const FIXRAD_IN_FLASH DeltaTable kLunes[kLuneTables];

constexpr int kLunePartsLog2 = 8;
constexpr int kLuneParts = 1 << kLunePartsLog2;

/// Positions along a row are counted in 1/4096 of its length, whatever the resolution.
constexpr int kRowLog2 = 12;
constexpr int32_t kRowEnd = 1 << kRowLog2;
constexpr int32_t kRowMiddle = kRowEnd / 2;

/// How many rows row `r` (0..R-1, bottom up) is away from the middle of the top, or from the horizon.
inline int rows_from_middle(const DeltaTable& table, int r) {
  const int half_size = 1 << (table.resolution_log2 - 1);
  return r >= half_size ? r - half_size : half_size - 1 - r;
}

/// One row of a table.
struct DeltaRow {
  const FIXRAD_FLASH uint16_t* half;
  uint8_t part_bits;    ///< 2^part_bits positions are one entry
  uint8_t shift;        ///< from entry * 2^part_bits to units of 2^-20
  uint32_t half_total;  ///< sum of half the row, 2^-20

  /// Running sum from the left end of the row to x (0..kRowEnd), 2^-20; monotone, linear within an entry.
  uint32_t sum_to(int32_t x) const {
    return x >= kRowMiddle ? half_total + half_sum(static_cast<uint32_t>(x - kRowMiddle))
                           : half_total - half_sum(static_cast<uint32_t>(kRowMiddle - x));
  }

 private:
  uint32_t half_sum(uint32_t distance) const {
    if (distance == static_cast<uint32_t>(kRowMiddle)) {
      return half_total;
    }
    const unsigned entry = static_cast<unsigned>(distance >> part_bits);
    const uint32_t part = distance & ((static_cast<uint32_t>(1) << part_bits) - 1u);
    const uint32_t below = entry == 0 ? 0u : flash_read(half, entry - 1);
    const uint32_t above = flash_read(half, entry);
    return ((below << part_bits) + (above - below) * part) >> shift;
  }
};

/// Row `r` (0..R-1, bottom up) of lunes or of a hemicube's top, or of its side (R/2..R-1 only: a side ends at
/// the horizon).
inline DeltaRow delta_row(const DeltaTable& table, bool is_top, int r) {
  if (table.cosine != nullptr) {
    constexpr int kPartBits = kRowLog2 - 1 - kLunePartsLog2;
    // An entry is in 2^-16 of a row, a row 2^(20 - k).
    return {table.top, kPartBits, static_cast<uint8_t>(kPartBits + table.resolution_log2 - 4),
            static_cast<uint32_t>(1) << (kDeltaSumLog2 - 1 - table.resolution_log2)};
  }
  const int half_size = 1 << (table.resolution_log2 - 1);
  const FIXRAD_FLASH uint16_t* half =
      (is_top ? table.top : table.side) + rows_from_middle(table, r) * half_size;
  const uint8_t part_bits = static_cast<uint8_t>(kRowLog2 - table.resolution_log2);
  return {half, part_bits, part_bits, flash_read(half, static_cast<unsigned>(half_size - 1))};
}

}  // namespace fixrad

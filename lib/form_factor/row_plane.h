// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/arithmetic.h"
#include "lib/form_factor/delta_table.h"

namespace fixrad {

/// A row of samples: the half-plane spanned by the local x axis (both ways) and a vector m = (0, y, z), z >
/// 0. Position p on the row, x = p - kRowMiddle, shows the direction (x, w y, w z) with w = kRowMiddle on a
/// row of a hemicube, where the row ends at the side's border, and w = kRowMiddle - |x| on a lune, which
/// reaches the axis at its ends. Both are straight lines in (x, w), so a plane through the eye meets a row
/// where a ratio of two numbers says (row_crossing), and is linear along it (a lune: from its middle on).
struct RowPlane {
  int32_t y, z;   ///< m, Q11; |m| <= sqrt(2) on a hemicube, 1 on a lune
  uint32_t fold;  ///< 0 on a hemicube; all ones on a lune
};

/// w of position x = p - kRowMiddle.
inline int32_t row_weight(int32_t x, uint32_t fold) {
  return kRowMiddle - static_cast<int32_t>(magnitude(x) & fold);
}

constexpr int kPlaneBits = 11;

/// Bits that row_crossing() takes.
constexpr int kCrossingBits = 19;

/// m of row `r` (0 .. R - 1, bottom up). A hemicube's rows are equally spaced on the side, a lune's in the
/// sine of their angle, so that each weighs the same.
inline RowPlane row_plane(const DeltaTable& table, int r) {
  const int32_t y = static_cast<int32_t>(2 * r + 1 - (1 << table.resolution_log2)) *
                    (static_cast<int32_t>(1) << (kPlaneBits - table.resolution_log2));
  if (table.cosine == nullptr) {
    return {y, static_cast<int32_t>(1) << kPlaneBits, 0};
  }
  return {y, flash_read(table.cosine, static_cast<unsigned>(rows_from_middle(table, r))), 0xfffffffful};
}

/// floor(2^11 n / d) for n < d, n < 2^20, by the division that the core has or that its compiler calls.
inline uint32_t fraction_plain(uint32_t n, uint32_t d) {
  return (n << kPlaneBits) / d;
}

/// The same, a bit at a time: eleven steps of compare and subtract, where a division routine has 32.
inline uint32_t fraction_stepwise(uint32_t n, uint32_t d) {
  uint32_t quotient = 0;
#pragma GCC unroll 11
  for (int i = 0; i < kPlaneBits; ++i) {
    n <<= 1;
    const bool fits = n >= d;
    quotient = 2 * quotient + (fits ? 1 : 0);
    n -= fits ? d : 0;
  }
  return quotient;
}

inline uint32_t row_fraction(uint32_t n, uint32_t d) {
  return kHasDivision ? fraction_plain(n, d) : fraction_stepwise(n, d);
}

/// Where a row meets the plane x s + m = 0 through the eye, s along the axis and 1 along the row's m: a
/// position 0 .. kRowEnd; its border if the plane meets the row beyond it. Needs |x|, |m| < 2^20. Cost: one
/// division of 11 quotient bits.
inline int32_t row_crossing(int32_t x, int32_t m, uint32_t fold) {
  const uint32_t n = magnitude(m);
  const uint32_t d = magnitude(x) + (n & fold);
  const int32_t offset = n >= d ? kRowMiddle : static_cast<int32_t>(row_fraction(n, d));
  return (x ^ m) < 0 ? kRowMiddle + offset : kRowMiddle - offset;
}

/// Part of a row: [begin, end), empty if begin >= end.
struct Interval {
  int32_t begin, end;
};

/// The crossing within `part` of a plane that is known to meet the row there, its side changing from below to
/// above (`rises`) or back. Where x says otherwise it is 0 but for rounding: the plane then meets the row in
/// its far end, whichever that is, and elsewhere keeps the sign of m.
inline int32_t crossing_within(Interval part, bool rises, int32_t x, int32_t m, uint32_t fold) {
  if (rises ? x <= 0 : x >= 0) {
    return (m > 0) == rises ? part.begin : part.end;
  }
  const int32_t position = row_crossing(x, m, fold);
  return position < part.begin ? part.begin : (position > part.end ? part.end : position);
}

/// A set of up to 16 rows: bit i is row `first + i` of the band.
using RowMask = uint16_t;
constexpr int kBandRows = 16;

/// Rows of the band that begins at row `first` of a table of R.
inline int band_count(const DeltaTable& table, int first) {
  const int rest = (1 << table.resolution_log2) - first;
  return rest < kBandRows ? rest : kBandRows;
}

/// The row that is being sampled, and its bit in the band's masks.
struct BandRow {
  RowPlane plane;
  RowMask bit;
};

/// Row `i` of the band that begins at row `first`.
inline BandRow band_row(const DeltaTable& table, int first, int i) {
  return {row_plane(table, first + i), static_cast<RowMask>(1u << i)};
}

}  // namespace fixrad

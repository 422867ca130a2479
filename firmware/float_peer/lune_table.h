// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/flash.h"

namespace fixrad {
namespace peer {

/// One lune: the row y = tangent on the plane at distance 1 in front of the eye, of the angle phi with sin
/// phi = (2 i + 1) / R. Position x of the row is s = x cosine along the unit half circle (docs/lunes.md).
struct Lune {
  float tangent, cosine;
};

/// All lunes over the normal, from the middle out, for R = 4, 8, 16, 32 one after the other.
const FIXRAD_FLASH Lune* all_lunes();

/// The running sum g(s) = (atan s + s / (1 + s^2)) / pi of a lune, as a straight line: intercept + slope s.
struct Segment {
  float intercept, slope;
};

/// Segments start at 2^-5 and end at 2^6, sixteen to each power of two: exponent and first four bits of a
/// float are the index. Between them g is met at its ends; the line is off by 0.00015 at most.
constexpr uint32_t kFirstSegment = 0x3d000000u >> 19;  // the bits of 2^-5
constexpr uint32_t kSegmentCount = 11 * 16;
const FIXRAD_FLASH Segment* lune_segments();

/// Before the first segment g is a line through 0.
constexpr float kMiddleSlope = 0.636206348f;  // 32 g(1/32)

/// Are there lunes for R = 2^resolution_log2?
inline bool has_lunes(unsigned resolution_log2) {
  return resolution_log2 >= 2 && resolution_log2 <= 5;
}

/// The lunes of one resolution; a row weighs 1.
struct LuneTable {
  uint8_t size;                    ///< R
  const FIXRAD_FLASH Lune* lunes;  ///< [R/2]
};

inline LuneTable lune_table(uint8_t resolution_log2) {
  const unsigned half = 1u << (resolution_log2 - 1);
  return {static_cast<uint8_t>(2 * half), all_lunes() + (half - 2)};
}

/// The sum from the middle of a lune to s, 1 for a whole lune; negative to the left of the middle. Cost: one
/// product, one sum.
inline float lune_sum(float s) {
  uint32_t bits;
  __builtin_memcpy(&bits, &s, sizeof bits);
  const uint32_t from_first = (bits << 1 >> 20) - kFirstSegment;
  if (from_first >= kSegmentCount) {
    if ((bits << 1 >> 20) < kFirstSegment) {
      return s * kMiddleSlope;
    }
    return bits >> 31 != 0 ? -0.5f : 0.5f;
  }
  const Segment segment = flash_read(lune_segments(), static_cast<unsigned>(from_first));
  const float middle = segment.slope * s;
  return bits >> 31 != 0 ? middle - segment.intercept : middle + segment.intercept;
}

/// One row: y on the plane in front of the eye.
struct LuneRow {
  float y, cosine;

  /// Sum from the middle of the row to position x, 1 for a whole row.
  float sum_to(float x) const { return lune_sum(x * cosine); }
};

/// Row `row` (0 .. R-1, bottom up).
inline LuneRow lune_row(const LuneTable& table, uint8_t row) {
  const uint8_t half = table.size / 2;
  const bool is_over = row >= half;
  const Lune lune = flash_read(table.lunes, is_over ? row - unsigned{half} : half - 1u - row);
  return {is_over ? lune.tangent : -lune.tangent, lune.cosine};
}

}  // namespace peer
}  // namespace fixrad

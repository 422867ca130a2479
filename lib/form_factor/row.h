// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/cutter.h"

namespace fixrad {

/// One over a row of form factors: the entries plus escaped plus back sum to exactly this. The unit is that
/// of the delta form factors: with 2^-16, rounding made nine tenths of all arithmetic error.
constexpr uint32_t kRowOne = 1ul << 20;

/// A row of form factors, the one record between geometry and transport: share[j] is the fraction of what a
/// shooter sends that arrives at element j. share [count], UQ1.20, owned by the solver's storage.
struct FormFactorRow {
  uint32_t* share;
  uint16_t count;
  uint32_t escaped;  ///< hits nothing, UQ1.20
  uint32_t back;     ///< the nearest hit is a back face, UQ1.20
};

/// Empties the row.
inline void clear(FormFactorRow& row) {
  for (uint16_t j = 0; j < row.count; ++j) {
    row.share[j] = 0;
  }
  row.escaped = 0;
  row.back = 0;
}

/// Slots that are no element.
constexpr uint16_t kEscapedSlot = 0xffff;
constexpr uint16_t kBackSlot = 0xfffe;

/// Adds the view of one eye point to a row. The eye owns the part `weight` of kRowOne; samples come in a
/// fixed order and each ends at a running sum of delta form factors, so that rounding telescopes: after the
/// last sample the eye has given exactly `weight`. Ends are rounded to nearest, lest the last element get all
/// that others lose.
class RowWriter {
 public:
  /// Goes on where an earlier one has come to `sum`: what that one's cutter had left over follows from it.
  FIXRAD_MODULO RowWriter(FormFactorRow& row, uint32_t weight, uint32_t sum = 0)
      : row_(row),
        cutter_(weight, (weight * sum + kRowOne / 2) & (kRowOne - 1)),
        sum_(sum),
        is_whole_(weight == kRowOne) {}

  /// Everything from the end of the last call up to `sum` (UQ1.20 over the hemisphere) falls on `slot`.
  void add(uint16_t slot, uint32_t sum) {
    const uint32_t all = sum - sum_;
    sum_ = sum;
    const uint32_t part = is_whole_ ? all : cutter_.cut(all);
    if (part != 0) {
      give(slot, part);
    }
  }

 private:
  void give(uint16_t slot, uint32_t part) {
    if (slot == kEscapedSlot) {
      row_.escaped += part;
    } else if (slot == kBackSlot) {
      row_.back += part;
    } else {
      row_.share[slot] += part;
    }
  }

  FormFactorRow& row_;
  Cutter cutter_;
  uint32_t sum_;
  bool is_whole_;
};

}  // namespace fixrad

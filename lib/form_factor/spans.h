// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/scanline.h"

namespace fixrad {

/// Sign of (1/depth of `a`) - (1/depth of `b`) in direction d (components at most 2^11), times both plane
/// distances: above 0 where a is nearer. 2^27 x 2^31 fits 64 bits; no division, no common scale.
int64_t nearness(const FaceView& a, const FaceView& b, Vec3 d);

/// What is visible along one row, resolved between faces: a linked list of spans from 0 to kRowEnd, each
/// showing one face or nothing, kept in a bounded pool.
class VisibleSpans {
 public:
  explicit VisibleSpans(Workspace& work) : work_(work) {}

  /// Starts a row that shows nothing.
  void reset();

  /// Shows view `index` on `part` where it is nearer than what is there; of equals the earlier one stays.
  /// Faces that pierce each other are split where they cross. False if the pool is full: the row is then
  /// unusable.
  bool insert(uint16_t index, Interval part, const RowPosition& at);

  uint16_t first() const { return 0; }
  const Span& operator[](uint16_t i) const { return work_.spans[i]; }
  int32_t end_of(uint16_t i) const;

 private:
  Interval nearer_part(uint16_t index, uint16_t other, Interval part, const RowPosition& at) const;
  uint16_t split(uint16_t i, int32_t x);
  bool paint(uint16_t& previous, uint16_t i, Interval part, uint16_t index);

  Workspace& work_;
  uint16_t free_ = kNoSpan;
  uint16_t used_ = 0;
};

}  // namespace fixrad

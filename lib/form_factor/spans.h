// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/scanline.h"

namespace fixrad {

/// 1/depth of a face along one row, in 2^-shift of a unit common to all faces: linear in a position's x and
/// w. x and m below 2^19, |at(p)| < 2^30.
struct RowDepth {
  int32_t x, m;
  uint32_t fold;
  uint8_t shift;

  int32_t at(int32_t position) const {
    const int32_t from_middle = position - kRowMiddle;
    return x * from_middle + m * row_weight(from_middle, fold);
  }
};

/// Needs view.depth.
RowDepth row_depth(const FaceView& view, const RowPlane& plane);

/// Above 0 where `a` is nearer than `b` at a position of the row, below 0 where b is.
int32_t nearness(const RowDepth& a, const RowDepth& b, int32_t position);

/// What is visible along one row, resolved between faces: spans in order from 0 to kRowEnd, each showing one
/// face or nothing, in a bounded pool; one span more, at kRowEnd, ends them.
class VisibleSpans {
 public:
  /// On rows of the view from `eye` that `work` holds. All must outlive it.
  VisibleSpans(const Scene& scene, const EyePoint& eye, Workspace& work)
      : scene_(scene), eye_(eye), work_(work) {}

  /// Starts a row that shows nothing. Needs a pool of two.
  void reset();

  /// Shows view `index` on `part` (not empty) where it is nearer than what is there; of equals the earlier
  /// one stays. Faces that pierce each other are split where they cross. False if the pool is full: the row
  /// is then unusable. Cost: linear in the number of spans; twelve products for each face that is met, and a
  /// division where they pierce each other. The first meeting in a view makes its depths; where nothing hides
  /// anything there is none.
  bool insert(uint16_t index, Interval part, const RowPlane& plane);

  uint16_t count() const { return count_; }
  uint16_t view(uint16_t i) const { return work_.spans[i].view; }
  Interval part(uint16_t i) const { return {work_.spans[i].start, work_.spans[i + 1].start}; }

 private:
  bool open(uint16_t i, uint16_t spans);
  void close(uint16_t i);
  bool paint(uint16_t& i, Interval part, uint16_t index);
  Interval won_part(uint16_t a, uint16_t b, Interval part, const RowPlane& plane);

  const Scene& scene_;
  const EyePoint& eye_;
  Workspace& work_;
  uint16_t count_ = 0;
};

}  // namespace fixrad

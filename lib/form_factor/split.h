// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/scanline.h"

namespace fixrad {

/// Walks the visible interval of one face along a row and cuts it where it crosses the face's element grid.
/// Both cell coordinates are monotone along the interval, so it steps from cell to cell.
///
///     for (ElementWalk walk(scene, view, at, part); walk.next();) use(walk.element(), walk.end());
///
/// Cost: six dot products and up to two divisions an interval, one division a crossing.
class ElementWalk {
 public:
  /// Needs part.begin < part.end, and `view` to show its front.
  ElementWalk(const Scene& scene, const FaceView& view, const RowPosition& at, Interval part);

  /// Moves to the next piece; false when the interval is used up.
  bool next();

  uint16_t element() const { return element_; }  ///< element of the current piece
  int32_t end() const { return end_; }           ///< where the piece ends, row position

 private:
  // One family of parallel grid lines: at the ends of the interval the cell coordinate is value / weight.
  struct Axis {
    int32_t begin_value, end_value;
    int16_t cell, cells;
    int16_t step;    // to the next cell: 1, -1, or 0 in the last one
    int32_t border;  // row position where the current cell ends
  };

  void start_axis(Axis& axis, Vec3 grid, uint8_t cells, Vec3 d0, Vec3 d1) const;
  void find_border(Axis& axis) const;
  uint16_t element_at(int16_t u, int16_t v) const;

  const Scene& scene_;
  const FaceView& view_;
  Interval part_;
  int32_t begin_weight_, end_weight_;
  Axis u_, v_;
  uint16_t element_ = 0;
  int32_t end_;
};

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/scanline.h"

namespace fixrad {
namespace peer {

/// Walks the visible interval of one face along a row and cuts it where it crosses the face's element grid.
///
///     for (ElementWalk walk(scene, view, y, part); walk.next();) use(walk.element(), walk.end());
///
/// Cost: one reciprocal for each end of the interval, one division a crossing.
class ElementWalk {
 public:
  /// The row at y. Needs part.begin < part.end, `view` to show its front and its row_depth to be up to date.
  ElementWalk(const Scene& scene, const FaceView& view, float y, Interval part);

  /// Moves to the next piece; false when the interval is used up.
  bool next();

  uint16_t element() const { return element_; }  ///< element of the current piece
  float end() const { return end_; }             ///< where the piece ends

 private:
  // One family of parallel grid lines. The line between cells k - 1 and k crosses the row where
  // value - k depth = 0, both linear: at -at_row / slope.
  struct Axis {
    float at_row, slope;
    float border;  // position where the current cell ends, while left > 0
    uint8_t cell;
    int8_t step;   // to the next cell
    uint8_t left;  // borders to come
  };

  void start_axis(Axis& axis, const RowFunction& value, uint8_t cells, float begin, float begin_depth,
                  float end_depth) const;
  void find_border(Axis& axis) const;
  void pass_border(Axis& axis) const;
  uint16_t element_at(uint8_t u, uint8_t v) const;

  const Scene& scene_;
  const FaceView& view_;
  Axis u_ = {0, 0, 0, 0, 0, 0};
  Axis v_ = {0, 0, 0, 0, 0, 0};
  float end_;
  float last_;
  uint16_t element_ = 0;
  bool is_done_ = false;
};

}  // namespace peer
}  // namespace fixrad

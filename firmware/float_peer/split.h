// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/scanline.h"

namespace fixrad {
namespace peer {

/// Walks the visible interval of one face along a row and cuts it where it crosses the face's element grid.
///
///     for (ElementWalk walk(scene, view, part); walk.next();) use(walk.element(), walk.end());
///
/// Cost: one reciprocal for each end of the interval, one division a crossing.
class ElementWalk {
 public:
  /// Needs part.begin < part.end, and `view` to show its front.
  ElementWalk(const Scene& scene, const FaceView& view, Interval part);

  /// Moves to the next piece; false when the interval is used up.
  bool next();

  uint16_t element() const { return element_; }  ///< element of the current piece
  float end() const { return end_; }             ///< where the piece ends

 private:
  // One family of parallel grid lines. The line between cells k - 1 and k crosses the row where
  // value - k depth = 0, both linear: at -above / along.
  struct Axis {
    float above, along;
    float border;  // position where the current cell ends, while left > 0
    uint8_t cell;
    int8_t step;   // to the next cell
    uint8_t left;  // borders to come
  };

  static void start_axis(Axis& axis, const FaceView& view, const RowFunction& value, uint8_t cells,
                         Interval part, float begin_depth, float end_depth);
  static void find_border(Axis& axis, float end);
  void pass_border(Axis& axis);
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

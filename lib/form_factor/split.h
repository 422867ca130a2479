// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/scanline.h"

namespace fixrad {

/// Walks the visible interval of one face along a row and cuts it where it crosses the face's element grid.
/// Both cell coordinates are monotone along the interval, so it steps from cell to cell. Within a cell that
/// is cut it goes down the tree of cuts, at each to the side where the interval enters first (Fuchs, Kedem &
/// Naylor 1980); the other side waits.
///
///     for (ElementWalk walk(scene, view, plane, part); walk.next();) use(walk.element(), walk.end());
///
/// Cost: 22 products and up to two divisions of 7 quotient bits an interval, three products and one division
/// of 11 a crossing; ten products a cut that is met, and a division where the interval crosses it.
class ElementWalk {
 public:
  /// Needs part.begin < part.end, and `view` to show its front.
  ElementWalk(const Scene& scene, const FaceView& view, const RowPlane& plane, Interval part);

  /// Moves to the next piece; false when the interval is used up.
  bool next();

  uint16_t element() const { return element_; }  ///< element of the current piece
  int32_t end() const { return end_; }           ///< where the piece ends, row position

 private:
  // One family of parallel grid lines along the row: the line between cells k - 1 and k is the zero of
  // (x - k weight_x_) s + (m - k weight_m_), s along the axis.
  struct Axis {
    int32_t x, m;
    int32_t end_value;  // (x, m) at the end of the interval
    int32_t border;     // row position where the current cell ends
    int16_t cell, cells;
    int16_t step;  // to the next cell: 1, -1, or 0 in the last one
  };

  // A position's coordinates, see RowPlane.
  struct Point {
    int32_t x, w;
    int32_t of(int32_t along_x, int32_t along_m) const {
      return along_x * x + rounded_shift(along_m, kPlaneBits) * w;
    }
  };

  // Grid coordinates less those of a cell's corner, and their common weight, as lines along the row; all six
  // numbers share one scale, below 2^19.
  struct CellLines {
    int32_t u_x, v_x, weight_x;
    int32_t u_m, v_m, weight_m;
  };

  // The side of a cut that is still to be walked, up to a row position.
  struct Waiting {
    uint16_t side;
    int16_t end;
  };

  void start_axis(Axis& axis, const Vec3& grid, uint8_t cells, const RowPlane& plane);
  void find_border(Axis& axis) const;
  uint16_t cell_at(int16_t u, int16_t v);
  int16_t first_row_of_cell() const;
  void enter_cell(uint16_t cell);
  void descend(uint16_t side, Interval part);

  const Scene& scene_;
  const FaceView& view_;
  Interval part_;
  uint32_t fold_;
  Point begin_point_ = {0, 0}, end_point_ = {0, 0};
  int32_t weight_x_ = 0, weight_m_ = 0;
  int32_t begin_weight_ = 1, end_weight_ = 1;
  Axis u_, v_;
  CellRow cell_row_ = {0, 0, 0};
  int16_t cell_row_number_ = -1;
  uint16_t element_ = 0;
  int32_t end_;
  CellLines cell_ = {0, 0, 0, 0, 0, 0};
  Waiting waiting_[kMostCuts];
  uint8_t waiting_count_ = 0;
};

}  // namespace fixrad

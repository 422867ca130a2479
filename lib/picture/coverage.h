// SPDX-License-Identifier: MIT
#pragma once

#include "lib/picture/projection.h"

namespace fixrad {

/// The first column whose centre is not left of an edge, row by row, exactly: the crossing is a fraction that
/// is carried along with its rest (Bresenham 1965). Two triangles that share the edge get the same columns.
class EdgeWalk {
 public:
  /// Stands at `row`, whose centre lies between the heights of `top` and `bottom` (top.y < bottom.y).
  /// Cost: a 64-bit division and one of 32 bits.
  EdgeWalk(const ScreenCorner& top, const ScreenCorner& bottom, int32_t row);

  int32_t column() const { return column_; }
  void next_row();

 private:
  uint32_t divisor_;  // 256 dy
  uint32_t rest_, rest_step_;
  int32_t column_, step_;
};

/// The first row (or column) whose centre is not above (left of) `at`, 1/256 pixel.
inline int32_t first_centre(int32_t at) {
  return floor_shift(at + (1l << (kPixelBits - 1)) - 1, kPixelBits);
}

/// The pixels of a triangle whose centres lie in it; of those on an edge, the ones with the triangle on their
/// right or, on a horizontal edge, below (the top-left rule). So of two triangles that share an edge exactly
/// one takes each pixel.
class Coverage {
 public:
  /// Corners in either sense.
  Coverage(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c);

  int32_t first_row() const { return first_centre(corner_[0].y); }
  int32_t end_row() const { return first_centre(corner_[2].y); }

  /// Calls row(y, first column, end column) for each row of [first, end) that the triangle has pixels in, cut
  /// to the columns [0, width).
  template <class Row>
  void rows(int32_t first, int32_t end, int32_t width, Row&& row) const {
    const int32_t bend = first_centre(corner_[1].y);
    part(first, bend < end ? bend : end, width, corner_[0], corner_[1], row);
    part(first > bend ? first : bend, end, width, corner_[1], corner_[2], row);
  }

 private:
  template <class Row>
  void part(int32_t first, int32_t end, int32_t width, const ScreenCorner& top, const ScreenCorner& bottom,
            Row& row) const {
    first = first > first_centre(top.y) ? first : first_centre(top.y);
    end = end < first_centre(bottom.y) ? end : first_centre(bottom.y);
    if (first >= end) {
      return;
    }
    EdgeWalk whole(corner_[0], corner_[2], first), half(top, bottom, first);
    for (int32_t y = first; y < end; ++y) {
      const int32_t left = is_bend_right_ ? whole.column() : half.column();
      const int32_t right = is_bend_right_ ? half.column() : whole.column();
      const int32_t from = left > 0 ? left : 0, to = right < width ? right : width;
      if (from < to) {
        row(y, from, to);
      }
      whole.next_row();
      half.next_row();
    }
  }

  ScreenCorner corner_[3];  // from the top
  bool is_bend_right_;      // the middle corner lies right of the edge from the top to the bottom
};

/// Twice the area of a triangle, 2^-16 pixels, positive if its corners run clockwise on the screen (y down).
int64_t screen_area(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c);

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/delta_table.h"
#include "lib/form_factor/view.h"

namespace fixrad {

/// The five sides of a hemicube. Each is the top seen in permuted axes: right-handed, z away from the eye
/// through the middle of the side, rows along x, y upwards (for the four sides: along the normal).
constexpr int kSides = 5;
constexpr int kTop = 0;

/// One row of a side: in the side's axes, position x has direction (x - kRowMiddle, y << (11 - k),
/// kRowMiddle), x in 0..kRowEnd.
struct RowPosition {
  int32_t row;          ///< 0..R-1 bottom up; sides start at R/2
  int resolution_log2;  ///< k
  int32_t y;            ///< height of the row, odd, -R < y < R, where the side's edge is R

  /// Direction of position x on the row, in the side's axes; components at most 2^11.
  Vec3 direction(int32_t x) const {
    return {x - kRowMiddle, y * (static_cast<int32_t>(1) << (kRowLog2 - 1 - resolution_log2)), kRowMiddle};
  }
};

/// Row `row` of a side.
inline RowPosition row_position(int32_t row, int resolution_log2) {
  return {row, resolution_log2, 2 * row + 1 - (static_cast<int32_t>(1) << resolution_log2)};
}

/// Part of a row: [begin, end), empty if begin >= end.
struct Interval {
  int32_t begin, end;
};

/// Turns the view from the axes of the side before to those of `side` (sides are entered in order, from
/// kTop), finds the rows of `side` that each face crosses and forgets the edge cursors. Cost: a few tests a
/// corner, one division a corner of a face in the side's frustum.
void enter_side(const Scene& scene, int side, int resolution_log2, Workspace& work);

/// The part of a row that a face covers. Needs first_row <= row <= last_row.
///
/// Which edges cross the row follows from the side of the row's plane that each vertex is on, the same for
/// all faces that share the vertex, and an edge's crossing is computed from its lower to its upper end, the
/// same for both faces that share it: neighbours tile the row without a gap, whatever was rounded. Cost: a
/// compare a corner in front of the eye, two products, a division where an edge begins.
Interval face_interval(const Scene& scene, const RowPosition& at, const Direction* directions,
                       FaceView& view);

}  // namespace fixrad

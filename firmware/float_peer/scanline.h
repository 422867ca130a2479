// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/lune_table.h"
#include "firmware/float_peer/view.h"

namespace fixrad {
namespace peer {

/// Directions are the points (x, y, 1) of the plane in front of the eye; a lune is the line of one y. It is
/// cut off where what is left weighs less than a float can tell from its whole.
constexpr float kRowEnd = 1024.0f;

/// Part of a row: [begin, end), empty if begin >= end.
struct Interval {
  float begin, end;
};

/// Finds which rows each vertex is above and which each face crosses. Cost: a division and a search among the
/// rows a vertex, a few integer operations a corner.
void enter_rows(const Scene& scene, const LuneTable& table, Workspace& work);

/// The part of a row, from -kRowEnd to kRowEnd, that a face covers; to be called for each of its rows
/// (begin_row .. end_row - 1) in order, y the row's own.
///
/// Which edges cross the row follows from the side of the row's plane that each vertex is on, as in the core;
/// they stay the same until a vertex of the face changes sides. An edge is a line between its vertices alone,
/// the same in both faces that share it: neighbours tile the row. Cost: two products, two sums and three
/// comparisons a row, one division where an edge begins.
Interval face_interval(const Scene& scene, uint8_t row, float y, const VertexView* vertices, FaceView& view);

}  // namespace peer
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/view.h"

namespace fixrad {

/// The five sides of a hemicube. Each is the top seen in permuted axes: right-handed, z away from the eye
/// through the middle of the side, rows along x, y upwards (for the four sides: along the normal).
constexpr int kSides = 5;
constexpr int kTop = 0;

/// Turns the view from the axes of the side before to those of `side`; sides are entered in order, from kTop.
void turn_view(int side, uint16_t vertex_count, Workspace& work);

/// Prepares the rows `first` .. first + count - 1 (count <= kBandRows) of a table's rows: which vertices are
/// above which row, which rows each face crosses. Cost: a search among the rows a vertex, a few bit
/// operations a corner.
void enter_band(const Scene& scene, const DeltaTable& table, int first, int count, Workspace& work);

/// The same on a side of a hemicube, where faces wholly outside of the side cross no row.
void enter_side_band(const Scene& scene, const DeltaTable& table, int side, int first, int count,
                     Workspace& work);

/// The part of a row that a face covers. Needs a row of view.rows.
///
/// Which edges cross the row follows from the side of the row's plane that each vertex is on, the same for
/// all faces that share the vertex, and an edge's crossing is computed from its lower to its upper end, the
/// same for both faces that share it: neighbours tile the row without a gap, whatever was rounded. Cost: two
/// products and a division an end, and a cross product where an edge begins.
Interval face_interval(const Scene& scene, const BandRow& row, const Direction* directions, FaceView& view);

}  // namespace fixrad

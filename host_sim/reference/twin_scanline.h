// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host_sim/reference/twin_view.h"

namespace fixrad::host {

/// One row of a hemicube side: position x in [-1, 1] has direction middle + x along, in the hemicube's frame.
struct TwinRow {
  glm::dvec3 along, middle;
  double y;  ///< height of the row, -1 < y < 1

  glm::dvec3 direction(double x) const { return middle + x * along; }
};

/// Part of a row: [begin, end), empty if begin >= end.
struct TwinInterval {
  double begin, end;
};

/// Row `r` (bottom up) of R on side `side`; the sides are the core's.
TwinRow twin_row(int side, int r, int resolution);

/// Turns all directions into the frame of `side`, finds the rows that each face crosses, forgets the edge
/// cursors.
void enter_twin_side(const TwinScene& scene, int side, int resolution, TwinView& view);

/// The part of a row that a face covers. Edges are computed from their lower to their upper end, the same for
/// both faces that share one: neighbours tile the row without a gap. Cost: two products a corner, two
/// divisions.
TwinInterval twin_face_interval(const TwinScene& scene, double y, const TwinView& view, TwinFaceView& face);

}  // namespace fixrad::host

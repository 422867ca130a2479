// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host_sim/reference/twin_view.h"

namespace fixrad::host {

/// A row of samples. Position x in [-1, 1] shows the direction x along + w middle, in the eye's frame, with w
/// = 1 on a hemicube and w = 1 - |x| on a lune.
struct TwinRow {
  glm::dvec3 along, middle;
  double y, z;  ///< middle in the frame of the side, (0, y, z)
  bool is_lune;

  glm::dvec3 direction(double x) const { return x * along + (is_lune ? 1 - std::fabs(x) : 1.0) * middle; }

  /// Position where the row meets the plane a s + m = 0 through the eye, s along `along` and 1 along
  /// `middle`; the row's end if it meets the plane beyond.
  double crossing(double a, double m) const {
    const double n = std::fabs(m);
    const double d = std::fabs(a) + (is_lune ? n : 0.0);
    const double x = n >= d ? 1.0 : n / d;
    return (a < 0) != (m < 0) ? x : -x;
  }

  /// The same for the plane that is perpendicular to `normal`, eye's frame.
  double crossing(const glm::dvec3& normal) const {
    return crossing(glm::dot(normal, along), glm::dot(normal, middle));
  }
};

/// Part of a row: [begin, end), empty if begin >= end.
struct TwinInterval {
  double begin, end;
};

/// Row `r` (bottom up) of R on side `side` of a hemicube; the sides are the core's.
TwinRow twin_row(int side, int r, int resolution);

/// Row `r` (bottom up) of R lunes.
TwinRow twin_lune(int r, int resolution);

/// Turns all directions into the frame of `side`, finds the rows that each face crosses, forgets the edge
/// cursors.
void enter_twin_side(const TwinScene& scene, int side, int resolution, TwinView& view);

/// The same for lunes, whose one side sees the whole hemisphere.
void enter_twin_lunes(const TwinScene& scene, int resolution, TwinView& view);

/// The part of a row that a face covers. Edges are computed from their lower to their upper end, the same for
/// both faces that share one: neighbours tile the row without a gap. Cost: two products a corner, two
/// divisions.
TwinInterval twin_face_interval(const TwinScene& scene, const TwinRow& row, const TwinView& view,
                                TwinFaceView& face);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/arc.h"
#include "lib/form_factor/cell_polygon.h"

namespace fixrad {

/// A surface point that polygons are seen from.
struct ContourPoint {
  Vec3 position;  ///< 1/64 grid unit
  Vec3 normal;    ///< unit vector, Q1.30
};

/// The point at `position` (1/64 grid unit) of a face.
ContourPoint contour_point(const Face& face, Vec3 position);

/// Form factor from a point to a polygon that nothing hides: Q1.30, positive where the polygon shows its
/// front, negative where it shows its back, 0 where it lies below the horizon or holds the point. Lambert's
/// contour formula (Lambert 1760; Schroeder & Hanrahan 1993, "On the Form Factor between Two Polygons",
/// equation 2):
///
///     F = 1/(2 pi) * sum over the edges of (angle that it spans) * (unit normal of its wedge . normal)
///
/// of the polygon's part above the horizon; where the contour dips below, the edge along the horizon closes
/// it. Error against the same formula in double: below 2^-24 where no edge spans more than 170 degrees,
/// 2^-19 where a point is so near to a long edge that it spans almost half a turn (tests/lib). Edges that two
/// polygons share cancel in the sum of both but for roundings. Cost: 45 to 70 wide products a corner, three
/// divisions for each of the two edges that cross the horizon.
int32_t contour_factor(const ContourPoint& point, const Polygon& polygon);

}  // namespace fixrad

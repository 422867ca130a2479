// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace fixrad::host {

/// Form factor from a differential area to a polygon, by Lambert's contour formula
///   F = 1/(2 pi) * sum over the edges of (angle that the edge spans) * (unit normal of its wedge . normal).
/// Closed form: exact but for rounding. Nothing blocks the view.
/// @param point    the differential area, scene units
/// @param normal   its unit normal
/// @param polygon  simple and planar, 3 corners or more, counter-clockwise seen from its lit side
/// @return in [0, 1]. What lies below the point's horizon does not count; 0 when the point is behind the
/// polygon
///         or in its plane. Finite everywhere, but on the polygon's very edge, where F jumps, it is one of
///         the values nearby.
/// Cost: a cross product and an arc tangent an edge.
/// Source: J. H. Lambert, Photometria, 1760; D. Baum, H. Rushmeier, J. Winget, SIGGRAPH 1989.
double point_to_polygon(const glm::dvec3& point, const glm::dvec3& normal,
                        const std::vector<glm::dvec3>& polygon);

}  // namespace fixrad::host

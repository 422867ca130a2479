// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace fixrad::host {

/// A simple polygon in the plane, counter-clockwise.
using Polygon2d = std::vector<glm::dvec2>;

/// Signed area, positive if counter-clockwise.
double area(const Polygon2d& polygon);

/// Centroid; for a polygon without area the mean of its corners.
glm::dvec2 centroid(const Polygon2d& polygon);

/// The part of a convex polygon where dot(normal, p) <= offset (Sutherland & Hodgman 1974); may be empty.
Polygon2d clip(const Polygon2d& polygon, glm::dvec2 normal, double offset);

/// The common part of two convex polygons; may be empty.
Polygon2d intersect(const Polygon2d& a, const Polygon2d& b);

}  // namespace fixrad::host

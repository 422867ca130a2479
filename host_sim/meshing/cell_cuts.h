// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "host_sim/meshing/element_grid.h"
#include "host_sim/meshing/segment_part.h"

namespace fixrad::host {

/// A line in a frame's (s, t) plane: all p with dot(normal, p) = offset.
struct Line2d {
  glm::dvec2 normal{0.0};
  double offset = 0;
};

/// The line from a to b; dot(normal, p) > offset to its left.
Line2d line_through(glm::dvec2 a, glm::dvec2 b);

/// The part of the segment from a to b that lies within a convex polygon.
SegmentPart part_within(const Polygon2d& polygon, glm::dvec2 a, glm::dvec2 b);

/// How small the parts of a cut may be.
struct LeastPart {
  double area = 0.02;  ///< of a whole cell's area
  double width = 2.0;  ///< grid units: twice the area over half the outline
};

/// Cuts element `index` of `face` in two along a line, which is rounded to what the core can hold (1/512 of a
/// cell). The part to its left stays at `index`, the other is appended. False, and nothing is changed, where
/// a part would be smaller than `least`, the cuts would be more than kMostCuts deep, or the element reaches
/// too far out of its cell. Cost: linear in the face's cuts.
bool cut_element(const FaceFrame& frame, FaceElements& face, std::size_t index, const Line2d& line,
                 const LeastPart& least = {});

/// Cuts every element of the face in which the segment from a to b is longer than `reach` (grid units).
/// Returns the number of cuts.
int cut_along(const FaceFrame& frame, FaceElements& face, glm::dvec2 a, glm::dvec2 b, double reach,
              const LeastPart& least = {});

}  // namespace fixrad::host

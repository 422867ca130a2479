// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host_sim/io/model.h"
#include "host_sim/meshing/quantise.h"

namespace fixrad::host {

/// A part of an input face inside a convex face.
struct FacePart {
  std::uint32_t input_face;
  std::vector<std::uint32_t> corners;  ///< convex, into QuantisedVertices::positions
};

/// A convex planar polygon on the grid, as the core takes it: an input face, a piece of one, or several
/// coplanar ones of one material joined.
struct ConvexFace {
  std::vector<std::uint32_t>
      corners;             ///< into QuantisedVertices::positions, counter-clockwise from the lit side
  glm::dvec3 normal{0.0};  ///< unit
  std::uint32_t material = 0;
  std::uint32_t smoothing_group = 0;
  std::vector<FacePart> parts;  ///< the input it consists of
};

struct ConvexFaces {
  std::vector<ConvexFace> faces;
  std::vector<std::string> warnings;
};

/// Cuts the model's faces into convex planar ones of at most kMaxCorners corners: concave, non-planar and
/// larger ones are triangulated (constrained Delaunay, GEOS). Faces that collapse on the grid are left out,
/// with one warning in all.
ConvexFaces make_convex(const Model& model, const QuantisedVertices& vertices);

/// Unit normal by Newell's method; zero for a polygon without area.
glm::dvec3 polygon_normal(const QuantisedVertices& vertices, const std::vector<std::uint32_t>& corners);

/// Whether the core accepts this polygon: planar and convex within the grid, no corner twice, at most
/// kMaxCorners.
bool is_convex_and_planar(const QuantisedVertices& vertices, const std::vector<std::uint32_t>& corners);

/// Joins neighbouring coplanar faces of one material while the result stays convex, rectangles first. Corners
/// that lie on a straight border stay, so that a conforming mesh stays conforming.
void merge_coplanar(const QuantisedVertices& vertices, ConvexFaces& faces);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace fixrad::host {

/// One element: a convex planar polygon of constant radiosity. Lengths in the scene's unit.
struct MeshElement {
  std::vector<glm::dvec3> polygon;  ///< 3 corners or more, counter-clockwise seen from the lit side
  glm::dvec3 centroid{0.0};
  glm::dvec3 normal{0.0};  ///< unit, towards the lit side
  double area = 0.0;       ///< of polygon
  glm::dvec3 reflectance{0.0};
  glm::dvec3 emission{0.0};  ///< emitted radiosity, W/m^2
  std::uint32_t input_face =
      0;  ///< a face of Model that this element lies on (the first, where faces were merged)
  std::uint32_t plane = 0;  ///< elements of one plane number lie in one plane and cannot see each other
};

/// The elements that a solver works on and the convex blockers between them, free of the core's integer
/// formats.
struct ElementMesh {
  std::vector<MeshElement> elements;
  /// Triangles that block light (from both sides): every face of the scene, lit or not, elements or not.
  std::vector<glm::dvec3> blocker_positions;
  std::vector<std::uint32_t> blocker_triangles;  ///< three indices into blocker_positions a triangle
};

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "host_sim/meshing/element_mesh.h"

namespace fixrad::host {

/// What a rectangle of a test scene is made of.
struct Paint {
  glm::dvec3 reflectance{0.0};
  glm::dvec3 emission{0.0};
};

/// Adds the parallelogram origin + s * u + t * v (s, t in [0, 1]) as a grid of columns x rows elements of one
/// new input face, lit on the side of u x v, and as a blocker.
void add_grid(ElementMesh& mesh, const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v,
              int columns, int rows, const Paint& paint);

/// Adds the same parallelogram as a blocker only.
void add_blocker(ElementMesh& mesh, const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v);

/// The unit cube seen from inside, subdivisions^2 elements a face; faces 0 and 1 are floor and ceiling. The
/// floor has paint `floor`, the others `walls`.
ElementMesh unit_cube(int subdivisions, const Paint& floor, const Paint& walls);

}  // namespace fixrad::host

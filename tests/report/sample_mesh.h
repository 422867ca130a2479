// SPDX-License-Identifier: MIT
// Meshes made by hand for the tests of the writers.
#pragma once

#include <glm/geometric.hpp>

#include "host_sim/report/baked_mesh.h"

namespace fixrad::host::testing {

/// Adds the parallelogram origin, origin + u, origin + u + v, origin + v as two triangles and one element;
/// its lit side is that of u x v.
inline void add_quad(BakedMesh& mesh, const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v,
                     const glm::dvec3& radiosity, const char* material = "white", bool lamp = false) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::dvec3 cross = glm::cross(u, v);
  for (const glm::dvec3& corner : {origin, origin + u, origin + u + v, origin + v}) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(glm::normalize(cross));
    mesh.radiosity.push_back(radiosity);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
  const auto index = static_cast<std::uint32_t>(mesh.elements.size());
  mesh.elements.push_back(
      {index, index, material, origin + 0.5 * (u + v), glm::length(cross), radiosity, lamp});
}

/// A square of side 2 in the plane z = 0 round the origin, lit side +z, one radiosity.
inline BakedMesh square(const glm::dvec3& radiosity) {
  BakedMesh mesh;
  mesh.name = "square";
  add_quad(mesh, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, radiosity);
  return mesh;
}

/// A box [0, 1]^3 that looks inwards, without its side z = 0: red at x = 1, green at x = 0, a lamp for a
/// ceiling.
inline BakedMesh open_room() {
  BakedMesh mesh;
  mesh.name = "open room";
  add_quad(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0.5, 0.5, 0.5});
  add_quad(mesh, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {40, 30, 20}, "lamp", true);
  add_quad(mesh, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0.5, 0.4, 0.3});
  add_quad(mesh, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0.6, 0.05, 0.05}, "red, \"matt\"");
  add_quad(mesh, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.4, 0.08}, "green");
  return mesh;
}

}  // namespace fixrad::host::testing

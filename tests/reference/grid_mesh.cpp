// SPDX-License-Identifier: MIT
#include "tests/reference/grid_mesh.h"

#include <cstdint>
#include <glm/geometric.hpp>

namespace fixrad::host {

void add_blocker(ElementMesh& mesh, const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v) {
  const auto first = static_cast<std::uint32_t>(mesh.blocker_positions.size());
  mesh.blocker_positions.insert(mesh.blocker_positions.end(),
                                {origin, origin + u, origin + u + v, origin + v});
  mesh.blocker_triangles.insert(mesh.blocker_triangles.end(),
                                {first, first + 1, first + 2, first, first + 2, first + 3});
}

void add_grid(ElementMesh& mesh, const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v,
              int columns, int rows, const Paint& paint) {
  const std::uint32_t face = mesh.elements.empty() ? 0 : mesh.elements.back().input_face + 1;
  const glm::dvec3 du = u / static_cast<double>(columns);
  const glm::dvec3 dv = v / static_cast<double>(rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const glm::dvec3 corner = origin + static_cast<double>(column) * du + static_cast<double>(row) * dv;
      MeshElement element;
      element.polygon = {corner, corner + du, corner + du + dv, corner + dv};
      element.centroid = corner + 0.5 * (du + dv);
      element.normal = glm::normalize(glm::cross(u, v));
      element.area = glm::length(glm::cross(du, dv));
      element.reflectance = paint.reflectance;
      element.emission = paint.emission;
      element.input_face = face;
      element.plane = face;
      mesh.elements.push_back(element);
    }
  }
  add_blocker(mesh, origin, u, v);
}

ElementMesh unit_cube(int subdivisions, const Paint& floor, const Paint& walls) {
  const glm::dvec3 x{1, 0, 0};
  const glm::dvec3 y{0, 1, 0};
  const glm::dvec3 z{0, 0, 1};
  const glm::dvec3 o{0.0};
  ElementMesh mesh;
  const int n = subdivisions;
  add_grid(mesh, o, x, y, n, n, floor);
  add_grid(mesh, z, y, x, n, n, walls);
  add_grid(mesh, o, y, z, n, n, walls);
  add_grid(mesh, x, z, y, n, n, walls);
  add_grid(mesh, o, z, x, n, n, walls);
  add_grid(mesh, y, x, z, n, n, walls);
  return mesh;
}

}  // namespace fixrad::host

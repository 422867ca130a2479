// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/quantise.h"
#include "host_sim/report/baked_mesh.h"

namespace fixrad::host {

/// A vertex between two of the mesh's.
struct InsertedPoint {
  std::uint32_t from, to;
  double part;  ///< of the way from the one to the other
};

/// A baked mesh on the device's grid, without T-vertices: no vertex lies on the side of a triangle.
struct ConformingMesh {
  std::vector<glm::ivec3> positions;  ///< of the mesh's vertices, then of those inserted
  std::vector<InsertedPoint> inserted;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> source;  ///< [triangles]: the mesh's triangle
};

/// Rounds the vertices, those of different surfaces that lie within a grid unit to the same point, and cuts
/// triangles whose side passes a vertex of another surface. Triangles that collapse are left out.
ConformingMesh make_conforming(const BakedMesh& mesh, const Grid& grid);

}  // namespace fixrad::host

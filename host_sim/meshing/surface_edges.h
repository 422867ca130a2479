// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/meshing/surface_mesh.h"

namespace fixrad::host {

/// An edge of the displayed triangles.
struct SurfaceEdge {
  std::uint32_t a, b;                   ///< vertices, a < b
  std::vector<std::uint16_t> elements;  ///< those of the triangles on its sides, ascending, each once
};

/// Every edge of the mesh's triangles once, ordered by (a, b).
std::vector<SurfaceEdge> surface_edges(const SurfaceMesh& mesh);

glm::dvec3 middle_of(const SurfaceMesh& mesh, const SurfaceEdge& edge);

/// `edges` and what must be cut with them so that triangles do not degenerate (M. C. Rivara, Int. J. Numer.
/// Methods Eng. 20, 1984): of each triangle that loses an edge, the longest too. Ordered by (a, b).
std::vector<SurfaceEdge> with_longest(const SurfaceMesh& mesh, const std::vector<SurfaceEdge>& edges);

/// Cuts each of `edges` in its middle: vertex count + i is the middle of edges[i]. The triangles on both
/// sides are cut with it into two to four, first at their longest edge, so the surface keeps no T-vertex and
/// no crack.
/// @param edges  as with_longest() gives them, of this mesh
void cut_edges(SurfaceMesh& mesh, const std::vector<SurfaceEdge>& edges);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// Distance in grid units within which a point counts as lying on a line or in a plane: corners are rounded
/// to the grid, by at most sqrt(3)/2.
constexpr double kOnPlane = 1.0;
/// The same for a plane that is itself drawn through rounded corners.
constexpr double kTouchingPlane = 2.0;

/// An edge between two neighbouring vertices, with all faces whose border runs along it.
struct SceneEdge {
  std::uint32_t p, q;  ///< into QuantisedVertices::positions, p < q
  std::vector<std::uint32_t> faces;
};

/// The sector that a face fills round one of its corners, or round a vertex on its border.
struct CornerSector {
  std::uint32_t face;
  std::uint32_t before, after;  ///< its neighbours on the face's border
};

/// Who borders on whom. Where a vertex lies on another face's border (a T-vertex) that border is cut in two,
/// so that neighbours are found whether the mesh conforms or not.
struct SceneEdges {
  std::vector<SceneEdge> edges;                    ///< ordered by (p, q)
  std::vector<std::vector<CornerSector>> sectors;  ///< [positions]
  /// [positions]: the vertex stands on the inside of a face that it does not belong to: no light passes
  /// behind it.
  std::vector<bool> is_on_a_face;
};

/// Cost: edges x vertices + faces x vertices.
SceneEdges find_edges(const PreparedScene& scene);

/// Whether `sector`'s face borders on the vertex that the list belongs to.
bool borders_on(const std::vector<CornerSector>& sectors, std::uint32_t face);

/// Whether a vertex lies on the silhouette as seen from `eye`: the faces round it, seen along the line
/// through both, do not cover the full turn, so that light passes beside it. Faces seen edge-on cover
/// nothing.
bool is_on_silhouette(const PreparedScene& scene, const SceneEdges& edges, std::uint32_t vertex,
                      const glm::dvec3& eye);

}  // namespace fixrad::host

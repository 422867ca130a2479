// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/io/model.h"

namespace fixrad::host {

/// The device's integer grid laid over a scene: grid = (p - origin) * scale, 0..16383 along the longest side
/// with a margin for eye points that are lifted off the outermost faces.
struct Grid {
  glm::dvec3 origin{0.0};  ///< scene position of grid point (0, 0, 0)
  double scale = 1.0;      ///< grid units a scene unit

  glm::dvec3 to_scene(glm::dvec3 grid_point) const { return origin + grid_point / scale; }
};

/// Vertices on the grid, equal ones welded.
struct QuantisedVertices {
  Grid grid;
  std::vector<glm::ivec3> positions;    ///< distinct
  std::vector<std::uint32_t> index_of;  ///< model vertex -> positions
  double largest_error = 0;             ///< of a used vertex, scene unit
};

/// Rounds the vertices that faces use to the grid. Throws InputError if the scene has no extent.
QuantisedVertices quantise(const Model& model);

}  // namespace fixrad::host

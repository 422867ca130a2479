// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "lib/scene/scene.h"

namespace fixrad::host {

/// A face with the exact normal of its corners on the grid; lengths in quarters of a grid unit, as eye points
/// are.
struct TwinFace {
  glm::dvec3 normal, tangent;  ///< unit vectors, perpendicular
  glm::dvec3 origin, axis_u, axis_v;
  std::uint32_t first_corner, corner_count;
  std::uint32_t first_cell_row;
  int cells_u, cells_v;
  bool is_sealed;
};

/// The core's scene in double. Positions, element grids and areas are the core's own integers, taken over as
/// numbers: rounding to the grid is the input of both. Normals, reflectances and emission are exact.
struct TwinScene {
  std::vector<glm::dvec3> vertices;  ///< quarters of a grid unit
  std::vector<std::uint16_t> corners;
  std::vector<TwinFace> faces;
  std::vector<CellRow> cell_rows;
  std::vector<std::uint16_t> roots;  ///< empty: no cell is cut
  std::vector<Cut> cuts;
  std::vector<double> element_area;  ///< 1/8 square grid units
  std::vector<double> reflectance;   ///< [element][channel]
  std::vector<double> emitted;       ///< [element][channel], flux units, not rounded
  std::uint32_t channels = 0;

  std::size_t element_count() const { return element_area.size(); }
};

inline glm::dvec3 to_double(const Vec3& a) {
  return {a.x, a.y, a.z};
}

/// Copies `scene`, which check_scene() must accept. Cost: linear.
TwinScene make_twin_scene(const Scene& scene);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// Triangles to samples: clipping, culling, depth buffer, perspective-correct interpolation.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/report/baked_mesh.h"
#include "host_sim/report/camera.h"

namespace fixrad::host {

/// A vertex in the picture. What is linear in space is linear in the picture once divided by the distance.
struct ScreenVertex {
  glm::dvec2 position{0.0};       ///< in samples, y down
  double inverse_distance = 0.0;  ///< 1 / distance along the view
  glm::dvec3 radiosity_over_distance{0.0};
};
using ScreenTriangle = std::array<ScreenVertex, 3>;

/// Where to put the near plane: a hundred thousandth of the diagonal of the mesh's box, > 0.
double near_distance(const BakedMesh& mesh);

/// The triangles of the mesh that face the camera, cut off where they come nearer than `near_distance` (> 0).
/// `sources`, where it is given, receives for each the index of the mesh's triangle.
std::vector<ScreenTriangle> visible_triangles(const BakedMesh& mesh, const Projection& projection,
                                              double near_distance,
                                              std::vector<std::uint32_t>* sources = nullptr);

/// A band of sample rows with depth.
struct SampleBand {
  int width = 0;
  int first_row = 0;
  int rows = 0;
  std::vector<double> inverse_distance;  ///< [rows * width], 0 where nothing was drawn
  std::vector<glm::dvec3> radiosity;     ///< [rows * width]
  std::vector<std::uint32_t> source;     ///< [rows * width], what draw() was told, where something was drawn

  /// The centre of sample `at` in the picture, in samples.
  glm::dvec2 centre(std::size_t at) const;

  /// Makes the band empty, for the rows from `first` on.
  void clear(int width_in_samples, int first, int count);
};

/// Draws one triangle into the band where it is nearer than what is there. A sample belongs to a triangle if
/// its centre lies inside or on an edge; triangles that share an edge leave no gap.
void draw(const ScreenTriangle& triangle, SampleBand& band, std::uint32_t source = 0);

}  // namespace fixrad::host

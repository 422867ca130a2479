// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/reference/twin_scene.h"
#include "lib/form_factor/view.h"

namespace fixrad::host {

/// An edge of a face that crosses rows, kept from row to row.
struct TwinEdgeCursor {
  glm::dvec3 normal;  ///< lower x upper end, frame of the current side; x < 0: in front of the eye
  int edge;           ///< which one is held, or kNoTwinEdge
};

constexpr int kNoTwinEdge = -1;

/// A face as the current eye sees it; vectors in the eye's frame.
struct TwinFaceView {
  glm::dvec3 plane;                   ///< 1/depth in direction d is plane . d
  glm::dvec3 grid_u, grid_v, grid_n;  ///< cell coordinate u in direction d is (grid_u . d) / (grid_n . d)
  TwinEdgeCursor left, right;
  std::uint32_t face;
  int first_row, last_row;  ///< rows of the current side that it may cross; first > last: none
  bool is_back;             ///< its back is seen: it blocks and is black
};

/// What one eye point sees, before anything hides anything. The arrays keep their size from eye to eye.
struct TwinView {
  explicit TwinView(const TwinScene& scene)
      : directions(scene.vertices.size()),
        side_directions(scene.vertices.size()),
        faces(scene.faces.size()) {}

  std::vector<glm::dvec3> directions;       ///< [vertices], eye's frame
  std::vector<glm::dvec3> side_directions;  ///< [vertices], frame of the current side
  std::vector<TwinFaceView> faces;          ///< [faces], `count` of them in use
  std::size_t count = 0;
};

/// As make_view() of the core: directions to all vertices, planes and grids of all faces that can be seen or,
/// whose `backs` take part.
void make_twin_view(const TwinScene& scene, const EyePoint& eye, Backs backs, TwinView& view);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// A segment of a face along which an edge of another face touches it, in the face's (s, t).
struct ContactLine {
  std::size_t face;
  glm::dvec2 a, b;
};

/// Where a block stands on a floor, or a shelf meets a wall: all edges of other planes that run within a
/// face, not along its border. Ordered by face. Cost: faces times edges.
std::vector<ContactLine> contact_lines(const PreparedScene& scene);

/// Cuts elements along contact lines. Radiosity jumps there, since what is covered is dark, and an element
/// across such a line carries light under the block to its dark foot; no other error of a mesh falls as
/// slowly with the size of its elements. Source: D. Baum, S. Mann, K. Smith, J. Winget, "Making radiosity
/// usable", SIGGRAPH 1991. Cost: lines times elements of their faces.
void cut_at_contacts(const PreparedScene& scene, Meshing& meshing);

}  // namespace fixrad::host

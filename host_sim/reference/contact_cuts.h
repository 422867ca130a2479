// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// A mesh in double and which input faces its elements lie on.
struct OverlappedMesh {
  ElementMesh mesh;
  std::vector<Overlap> overlaps;  ///< ordered by element
};

/// Cuts elements where an edge of another face runs along them: where a block stands on a floor, or a shelf
/// meets a wall. Radiosity jumps there, since what is covered is dark, and an element across such a line
/// carries light under the block; no other error of a mesh falls as slowly with the size of its elements.
/// @param scene   what `device` was made of
/// @return elements that are cut along the whole line through them; those without contact as they were
/// Cost: elements times edges.
/// Source: D. Baum, S. Mann, K. Smith, J. Winget, "Making radiosity usable", SIGGRAPH 1991.
OverlappedMesh cut_at_contacts(const PreparedScene& scene, const DeviceScene& device);

}  // namespace fixrad::host

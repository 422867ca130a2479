// SPDX-License-Identifier: MIT
#pragma once

#include "lib/scene/scene.h"
#include "lib/scene/status.h"

namespace fixrad {

/// What a storage has room for.
struct Capacity {
  uint16_t vertices, faces, elements;
  uint8_t channels;
};

/// Checks what the solver later relies on without looking: indices, coordinates on the grid,
/// planarity and convexity within the grid, areas, eye points, reflectance headroom, emission, capacity.
/// Reads only. Returns ok or the first fault. Cost: linear, but for corners within a face.
Status check_scene(const Scene& scene, const Capacity& capacity);

}  // namespace fixrad

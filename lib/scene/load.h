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

/// A scene is closed if every edge belongs to two faces that run along it in opposite directions (as many one
/// way as the other, where several meet). Cost: quadratic in the number of corners, stops at the first open
/// edge.
bool is_closed(const Scene& scene);

/// Closed, and light is inside: the faces, taken together, bound their volume from within, as a room does. A
/// body in empty space is closed, but its light escapes.
bool is_enclosed(const Scene& scene);

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include "lib/scene/scene.h"

namespace fixrad {

/// A scene is closed if every edge belongs to two faces that run along it in opposite directions (as many one
/// way as the other, where several meet). Cost: quadratic in the number of corners, stops at the first open
/// edge.
bool is_closed(const Scene& scene);

/// Closed, and light is inside: the faces, taken together, bound their volume from within, as a room does. A
/// body in empty space is closed, but its light escapes.
bool is_enclosed(const Scene& scene);

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host_sim/meshing/device_scene.h"
#include "lib/vertices/vertex_gather.h"

namespace fixrad::host {

/// The gather point of an element for a point of its plane: moved towards the element's centroid by 1/700 of
/// the scene's size at most, and lifted until the core sees it on the face's lit side.
/// @param position  scene unit, in the element or on its border
GatherPoint gather_point(const DeviceScene& device, std::uint16_t element, glm::dvec3 position);

/// The gather points of a displayed vertex: one in each of the `elements` that meet there (a fair choice of
/// 16 where there are more), twice the same where it is one, so that at least two turns of the axis are
/// averaged.
std::vector<GatherPoint> gather_points(const DeviceScene& device, glm::dvec3 position,
                                       const std::vector<std::uint16_t>& elements);

}  // namespace fixrad::host

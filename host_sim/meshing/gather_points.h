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

/// How a displayed vertex gathers: the arguments of gather_vertex().
struct VertexGather {
  std::vector<GatherPoint> points;
  std::uint8_t enough = 1;  ///< clear points
};

/// One point in each of the `elements` that meet in a displayed vertex (a fair choice of 16 where there are
/// more). Two clear ones are enough, and are the same twice where there is one element, so that two turns of
/// the axis are averaged; where the surface is curved every point counts.
VertexGather vertex_gather(const DeviceScene& device, glm::dvec3 position,
                           const std::vector<std::uint16_t>& elements);

}  // namespace fixrad::host

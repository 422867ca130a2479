// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// A face that may stand between two others, as indices into PreparedScene::faces.
struct Occlusion {
  std::uint32_t blocker, from, to;
};

/// The first face that may hide a part of one face from another; nothing if every pair that can see each
/// other is wholly visible. Safe, not sharp: no answer but nothing is a proof (a face counts as a blocker
/// unless a separating plane between it and the hull of the two others is found among the likely ones). Faces
/// may touch: what overlaps by less than two grid units does not hide. Cost: cubic in the number of faces
/// where many stand before each other's planes and none blocks; in a convex room quadratic.
std::optional<Occlusion> find_occlusion(const PreparedScene& scene);

}  // namespace fixrad::host

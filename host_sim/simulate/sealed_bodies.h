// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/meshing/device_scene.h"
#include "lib/fixrad.h"

namespace fixrad::host {

/// Marks the faces (Face::is_sealed) of bodies into which no clear eye sees, so that views leave out their
/// backs. A body is what hangs together by shared edges; it is sealed if every edge that only one face has
/// lies on faces of other bodies (a block without a bottom on a floor), and if no clear eye of the scene sees
/// the back of one of its faces on 16 lunes (a room is sealed too, but seen from outside its walls are open).
/// Needs device.sights and the pools that `sizes` names. Cost: edges x faces, and a view an element.
void seal_bodies(DeviceScene& device, const Sizes& sizes);

}  // namespace fixrad::host

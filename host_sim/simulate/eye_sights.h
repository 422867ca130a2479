// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/meshing/device_scene.h"
#include "lib/fixrad.h"

namespace fixrad::host {

/// Fills device.sights, so that the core need not probe: where an element's centroid is clear and where it is
/// buried, by the core's own probe; and where none of its eye points can be buried, since no other face meets
/// its part of the plane and nothing hides the centroid's view at all. Needs the pools that `sizes` names.
/// Cost: a clip a pair of faces and one probe an element.
void find_sights(DeviceScene& device, const Sizes& sizes);

}  // namespace fixrad::host

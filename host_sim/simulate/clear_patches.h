// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/meshing/device_scene.h"
#include "lib/fixrad.h"

namespace fixrad::host {

/// Marks the patches none of whose eye points can be buried, so that the core need not probe them: no other
/// face meets the patch's part of its plane, and the core's own probe finds its centroid clear. Conservative:
/// a patch that is not marked is probed. Needs the pools that `sizes` names. Cost: a clip a pair of faces and
/// one probe a patch.
void mark_clear_patches(DeviceScene& device, const Sizes& sizes);

}  // namespace fixrad::host

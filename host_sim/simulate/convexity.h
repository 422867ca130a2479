// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// A scene is convex if no face can hide another, or bury its eyes, seen from any lit side: every vertex of a
/// face lies in or before the plane of every face, and faces in one plane that look the same way lie side by
/// side; all within kPlaneTolerance. Plates that face each other are convex as well as an empty room. Views
/// of it make no depth. Cost: faces x corners.
bool is_convex(const DeviceScene& device);

}  // namespace fixrad::host

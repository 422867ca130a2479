// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// Mean error of what a mesh shows of the lamps' direct light, over its mean: at some 5,000 evenly spread
/// points of the faces but lamps and what is buried, the closed form against
struct ShadingError {
  double vertices;  ///< the closed form at the displayed mesh's vertices, interpolated on its triangles
  double elements;  ///< the mean over the element
};

ShadingError shading_error(const PreparedScene& scene, const Meshing& meshing);

}  // namespace fixrad::host

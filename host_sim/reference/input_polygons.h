// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host_sim/meshing/device_scene.h"
#include "host_sim/meshing/element_mesh.h"

namespace fixrad::host {

/// The faces of a scene as its file has them, for tracing: corners are not rounded to the device's grid and
/// nothing is cut into elements. Concave faces come in the convex pieces that the core takes; what is not
/// planar to 1e-9 of the scene's size comes as triangles. Faces that collapse on the grid are included.
/// @return polygons with their material and input_face, in no particular order; `plane` is not set
std::vector<MeshElement> input_polygons(const PreparedScene& scene);

}  // namespace fixrad::host

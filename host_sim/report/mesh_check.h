// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/report/baked_mesh.h"

namespace fixrad::host {

/// Throws std::invalid_argument, which is a fault of the caller and not of the user's scene, unless the mesh
/// has a triangle, one unit normal and one radiosity a vertex, indices in range, and finite numbers with
/// radiosity
/// >= 0. Every writer starts with it, so that no file is begun for a mesh that it cannot hold. O(n).
void check_mesh(const BakedMesh& mesh);

}  // namespace fixrad::host

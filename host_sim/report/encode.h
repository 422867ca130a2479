// SPDX-License-Identifier: MIT
// Files as bytes in memory, for writers and for pages that hold them.
#pragma once

#include <string>

#include "host_sim/report/picture.h"

namespace fixrad::host {

/// 8-bit RGB PNG.
std::string encode_png(const Image& image);

/// What write_glb() writes. Throws std::invalid_argument if check_mesh refuses the mesh.
std::string encode_glb(const BakedMesh& mesh, const Display& display);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/meshing/quantise.h"

namespace fixrad::host {

/// Cuts a simple polygon, concave or not quite planar, into triangles with its own corners only (constrained
/// Delaunay, GEOS), oriented like the polygon; triangles without area are left out. A polygon that crosses
/// itself is fanned from its first corner.
std::vector<std::vector<std::uint32_t>> triangulate(const QuantisedVertices& vertices,
                                                    const std::vector<std::uint32_t>& corners);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "host_sim/meshing/element_mesh.h"
#include "host_sim/reference/form_factors.h"
#include "host_sim/reference/visibility.h"

namespace fixrad::host {

/// The exchange area A_i F_ij = A_j F_ji of two elements, scene units squared: what form_factors() is made
/// of.
/// @param stream  number of the pair; the jitter of its rays depends on it alone
/// Cost: 4 contours and 16 rays for a distant pair, up to some thousand of each for touching or half hidden
/// ones; nothing but a few dot products where the two do not face each other.
double exchange(const MeshElement& i, const MeshElement& j, const RayScene& scene,
                const FormFactorOptions& options, std::uint64_t stream);

}  // namespace fixrad::host

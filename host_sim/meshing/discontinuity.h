// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "host_sim/meshing/device_scene.h"
#include "host_sim/meshing/element_light.h"

namespace fixrad::host {

/// How elements are shared out.
struct DiscontinuityOptions {
  double coarse = 0.6;    ///< of the elements, for the uniform mesh that is cut
  LightWeights weights;   ///< of errors other than that of the shading
  bool use_lines = true;  ///< false: halvings only, an adaptive mesh for the direct light
};

/// A mesh whose elements end where the lamps' light is not smooth. A coarse uniform mesh is cut, the element
/// with most misplaced light first, each along that line which leaves least of it in the two parts: a
/// critical line through the element (find_critical_lines()) or a halving. The light is the lamps' direct
/// light, in closed form at a few dozen points an element; reflected light, smooth but for contact lines, has
/// no say.
///
/// At most `elements` elements, but at least one a face; grouped into about `patches` patches. Deterministic.
/// Cost: some 25 points of direct light an element.
Meshing make_discontinuity(const PreparedScene& scene, std::uint32_t elements, std::uint32_t patches,
                           const DiscontinuityOptions& options = {});

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/element_mesh.h"

namespace fixrad::host {

struct RayCastOptions {
  std::uint32_t rays = 16;  ///< a pair, 1 to 32
  double unshot = 0.001;    ///< stop fraction
  bool overshoot = true;    ///< as the core: at most the element's own unshot flux, until 8 x unshot
  /// Keep the exchange of each pair: by reciprocity no ray is cast twice, for size^2 * 4 bytes. Without it
  /// each shot casts its rays anew, as on a machine that cannot hold a matrix.
  bool keep_pairs = true;
};

struct RayCastResult {
  std::vector<glm::dvec3> radiosity;  ///< [elements], W/m^2
  std::uint32_t shots = 0;
  std::uint64_t pairs = 0;  ///< for which rays were cast or would have been, had they faced each other
  double seconds = 0;       ///< of the shots, without building the ray caster
};

/// The yardstick for speed: progressive refinement in double on the host, with form factors by ray casting
/// (Embree), area to area. For each pair `rays` stratified points of either element are joined at random; a
/// ray that gets through counts the point-to-point form factor, or for a pair that is near the closed form
/// from that point to the whole shooter. One thread; packets of eight rays. Deterministic: the same arguments
/// give the same result.
/// @throws std::invalid_argument when rays is not 1 to 32
/// Sources: M. Cohen et al., SIGGRAPH 1988 (progressive refinement); J. Wallace, K. Elmquist, E. Haines,
/// SIGGRAPH 1989 (by ray casting).
RayCastResult ray_cast_shooting(const ElementMesh& mesh, const RayCastOptions& options = {});

}  // namespace fixrad::host

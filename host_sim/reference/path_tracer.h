// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/element_mesh.h"

namespace fixrad::host {

struct PathTracingOptions {
  std::uint32_t paths_per_element = 4096;  ///< rounded up to a multiple of batches
  std::uint32_t batches = 16;  ///< independent repetitions that give the standard error, 2 or more
  std::uint64_t seed = 1;
};

/// Means over elements, in the order of the mesh, W/m^2.
struct PathTracedRadiosity {
  std::vector<glm::dvec3> mean;
  std::vector<glm::dvec3> standard_error;  ///< independent between elements
};

/// Mean radiosity of each element by Monte Carlo, free of any mesh error: light arrives at points, not at
/// elements. From quasi-random points of an element cosine-distributed paths run through the scene until
/// Russian roulette by reflectance ends them; lamps are also sampled by area at every bounce, both ways
/// weighted by the balance heuristic (Veach 1995), except where most surfaces emit. Unbiased; back faces are
/// black and block. What stands in the way are the elements themselves: they must cover every face that
/// blocks. The result depends on mesh and options only, not on the number of threads. Cost: about 1 s per
/// million paths and core, growing as 1 / (1 - reflectance).
/// @throws std::invalid_argument when paths_per_element is 0 or batches < 2
PathTracedRadiosity path_traced_radiosity(const ElementMesh& mesh, const PathTracingOptions& options = {});

}  // namespace fixrad::host

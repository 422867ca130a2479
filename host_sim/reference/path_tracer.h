// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/element_mesh.h"
#include "host_sim/reference/path_estimator.h"

namespace fixrad::host {

/// Reference 3, the truth: Monte Carlo, free of any mesh error, since light arrives at points and not at
/// elements. See PathEstimator for the paths. Samples come in independent copies (batches) of one evenly
/// spread set, whose scatter is the standard error; the true value lies within three of them but for one case
/// in two hundred. Results depend on the arguments only: not on the number of threads nor on their order.
/// What stands in the way are the polygons given: they must cover every face that blocks.

/// Values and their standard errors, W/m^2.
struct Traced {
  std::vector<glm::dvec3> mean;
  std::vector<glm::dvec3> standard_error;  ///< independent between entries
};

struct FaceTracingOptions {
  std::uint64_t paths = 1U << 22U;  ///< in all; each face gets as many of them as its noise deserves
  std::uint32_t batches = 16;       ///< 2 or more
  std::uint64_t seed = 1;
};

/// Mean radiosity of each input face, such as input_polygons() gives them: no mesh is needed.
/// A first round measures the noise of each face. The rest goes where it lowers most the sum of standard
/// errors, weighted by area for the mean error of all faces and by 1/radiosity so that small and dark faces
/// are not forgotten.
/// @param polygons  those of one `input_face` are sampled as one surface
/// @return indexed by input face; 0 for one without polygons
/// Cost: about 0.7 s per million paths and core at reflectance 0.7; it grows as 1 / (1 - reflectance).
/// @throws std::invalid_argument when there are less than 2 batches
Traced path_traced_faces(const std::vector<MeshElement>& polygons, const FaceTracingOptions& options = {});

struct PointTracingOptions {
  std::uint32_t paths_per_point = 4096;  ///< rounded up to a power of two a batch
  std::uint32_t batches = 16;            ///< 2 or more
  std::uint64_t seed = 1;
};

/// Irradiance at points of surfaces; times reflectance, plus emission, it is radiosity. A point where faces
/// meet is taken to lie just off the other faces, on their lit sides.
/// @throws std::invalid_argument when there are less than 2 batches
Traced path_traced_irradiance(const std::vector<MeshElement>& polygons,
                              const std::vector<SurfacePoint>& points,
                              const PointTracingOptions& options = {});

struct PathTracingOptions {
  std::uint32_t paths_per_element = 4096;  ///< rounded up to a power of two a batch
  std::uint32_t batches = 16;              ///< 2 or more
  std::uint64_t seed = 1;
};

using PathTracedRadiosity = Traced;

/// Mean radiosity of each element, in the order of the mesh, whose elements are all that blocks.
/// @throws std::invalid_argument when paths_per_element is 0 or batches < 2
PathTracedRadiosity path_traced_radiosity(const ElementMesh& mesh, const PathTracingOptions& options = {});

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

struct RefinementOptions {
  double tolerance = 0.001;  ///< settled once a doubling moves face means by less, see Refined::change
  std::uint32_t first_elements = 500;  ///< of the coarsest mesh, at least six a face
  std::uint32_t most_elements = 4000;  ///< of the finest, cuts apart: memory is 16 bytes times its square
};

/// A radiosity solution whose mesh has been refined until it no longer mattered.
struct RefinedRadiosity {
  std::vector<glm::dvec3> face_means;  ///< [input faces], W/m^2
  std::uint32_t elements = 0;          ///< of the finest mesh
  /// Mean error of the last mesh but one against the last, as FaceMeanError::mean; infinite where the scene
  /// is so large that there was only one mesh.
  double change = 0.0;
  bool settled = false;  ///< change is below the tolerance
};

/// Radiosity with accurate form factors on uniform meshes, cut where faces touch (cut_at_contacts), each with
/// twice the elements of the one before, until face means settle or the largest mesh is reached. Independent
/// of the mesh and the form factors of the core. Cost: some 1 s for 2000 elements on two cores, growing with
/// their square.
RefinedRadiosity refined_radiosity(const PreparedScene& scene, const RefinementOptions& options = {});

}  // namespace fixrad::host

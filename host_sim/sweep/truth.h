// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/device_scene.h"
#include "host_sim/reference/error_budget.h"

namespace fixrad::host {

/// What solutions of a scene are measured against: path-traced means of its faces, free of any mesh error.
struct Truth {
  std::vector<glm::dvec3> means;  ///< [input faces], W/m^2
  std::vector<double> areas;      ///< [input faces], scene units
  std::vector<bool> emits;        ///< [input faces]
  double standard_error = 0;      ///< mean over faces, relative as FaceMeanError::mean
};

/// Traces the truth of `scene`. Depends on the scene only, not on the number of threads. Cost: about 3 s a
/// core for a room.
Truth trace_truth(const PreparedScene& scene);

/// How far `element_radiosity` on `device` is from the truth.
FaceMeanError error_against(const Truth& truth, const PreparedScene& scene, const DeviceScene& device,
                            const std::vector<glm::dvec3>& element_radiosity);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace fixrad::host {

/// How far one set of face means is from another.
struct FaceMeanError {
  double mean =
      0;  ///< sum of area |a - b| over sum of area b, faces that emit left out (unless all do), all channels
  double worst =
      0;  ///< largest |a - b| / b of a face with at least a tenth of the mean radiosity, channels summed
  std::size_t worst_face = 0;  ///< that face
};

/// `a`, `b`: radiosity [faces]; `areas` [faces], 0 leaves a face out; `emits` [faces].
FaceMeanError compare_face_means(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b,
                                 const std::vector<double>& areas, const std::vector<bool>& emits);

}  // namespace fixrad::host

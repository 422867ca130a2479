// SPDX-License-Identifier: MIT
#include "host_sim/reference/error_budget.h"

#include <algorithm>
#include <cmath>

#include "host_sim/io/model.h"

namespace fixrad::host {
namespace {

double distance(glm::dvec3 a, glm::dvec3 b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

}  // namespace

FaceMeanError compare_face_means(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b,
                                 const std::vector<double>& areas, const std::vector<bool>& emits) {
  // Where every face emits, as in a furnace, there is nothing to leave out.
  const bool counts_all = std::find(emits.begin(), emits.end(), false) == emits.end();
  double error = 0, light = 0, area = 0;
  for (std::size_t f = 0; f < b.size(); ++f) {
    if (counts_all || !emits[f]) {
      error += areas[f] * distance(a[f], b[f]);
      light += areas[f] * channel_sum(b[f]);
      area += areas[f];
    }
  }
  FaceMeanError result;
  if (light <= 0) {
    return result;
  }
  result.mean = error / light;
  for (std::size_t f = 0; f < b.size(); ++f) {
    if ((counts_all || !emits[f]) && areas[f] > 0 && channel_sum(b[f]) >= 0.1 * light / area) {
      const double of_face = distance(a[f], b[f]) / channel_sum(b[f]);
      if (of_face >= result.worst) {
        result.worst = of_face;
        result.worst_face = f;
      }
    }
  }
  return result;
}

}  // namespace fixrad::host

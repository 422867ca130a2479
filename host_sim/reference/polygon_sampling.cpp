// SPDX-License-Identifier: MIT
#include "host_sim/reference/polygon_sampling.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

/// How far the diagonals' midpoints may differ, relative to an edge, for a parallelogram.
constexpr double kParallelogramTolerance = 1e-9;

bool is_parallelogram(const std::vector<glm::dvec3>& polygon) {
  return polygon.size() == 4 && glm::length(polygon[0] - polygon[1] + polygon[2] - polygon[3]) <=
                                    kParallelogramTolerance * glm::length(polygon[2] - polygon[0]);
}

double fan_area(const std::vector<glm::dvec3>& polygon, std::size_t k) {
  return glm::length(glm::cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]));
}

}  // namespace

PolygonSampler::PolygonSampler(const std::vector<glm::dvec3>& polygon) : corners_(polygon) {
  if (is_parallelogram(polygon)) {
    return;
  }
  double total = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    total += fan_area(polygon, k);
    cumulative_.push_back(total);
  }
}

glm::dvec3 PolygonSampler::sample(double u, double v) const {
  const glm::dvec3& origin = corners_[0];
  if (cumulative_.empty()) {
    return origin + u * (corners_[1] - origin) + v * (corners_[3] - origin);
  }
  const double at = u * cumulative_.back();
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, at);
  const auto k = static_cast<std::size_t>(found - cumulative_.begin());
  const double before = k == 0 ? 0.0 : cumulative_[k - 1];
  const double area = *found - before;
  // The triangle's own u, stretched again to [0, 1]; the square root makes the map keep areas.
  const double along = std::sqrt(area > 0.0 ? std::clamp((at - before) / area, 0.0, 1.0) : 0.0);
  return origin + along * ((1.0 - v) * (corners_[k + 1] - origin) + v * (corners_[k + 2] - origin));
}

glm::dvec3 sample_polygon(const std::vector<glm::dvec3>& polygon, double u, double v) {
  return PolygonSampler(polygon).sample(u, v);
}

std::array<QuadraturePoint, 4> QuadratureCell::points() const {
  constexpr std::array<double, 2> kAbscissae{0.21132486540518713, 0.7886751345948129};  // (1 -+ 1/sqrt 3) / 2
  std::array<QuadraturePoint, 4> rule;
  std::size_t k = 0;
  for (const double gauss_v : kAbscissae) {
    for (const double gauss_u : kAbscissae) {
      const double s = u + size * gauss_u;
      const double t = v + size * gauss_v;
      const glm::dvec3 bottom = corners[0] + s * (corners[1] - corners[0]);
      const glm::dvec3 top = corners[3] + s * (corners[2] - corners[3]);
      const glm::dvec3 along_u = (1.0 - t) * (corners[1] - corners[0]) + t * (corners[2] - corners[3]);
      const double jacobian = glm::length(glm::cross(along_u, top - bottom));
      rule[k++] = {bottom + t * (top - bottom), 0.25 * size * size * jacobian};
    }
  }
  return rule;
}

std::array<QuadratureCell, 4> QuadratureCell::split() const {
  const double half = 0.5 * size;
  return {QuadratureCell{corners, u, v, half}, QuadratureCell{corners, u + half, v, half},
          QuadratureCell{corners, u, v + half, half}, QuadratureCell{corners, u + half, v + half, half}};
}

std::vector<QuadratureCell> quadrature_cells(const std::vector<glm::dvec3>& polygon) {
  std::vector<QuadratureCell> cells;
  for (std::size_t k = 1; k + 1 < polygon.size(); k += 2) {
    const std::size_t last = std::min(k + 2, polygon.size() - 1);
    cells.push_back({{polygon[0], polygon[k], polygon[k + 1], polygon[last]}});
  }
  return cells;
}

}  // namespace fixrad::host

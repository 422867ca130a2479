// SPDX-License-Identifier: MIT
#include "host_sim/meshing/polygon2d.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace

double area(const Polygon2d& polygon) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return sum / 2;
}

glm::dvec2 centroid(const Polygon2d& polygon) {
  glm::dvec2 sum(0.0), mean(0.0);
  double weight = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    mean += polygon[i] / static_cast<double>(polygon.size());
    if (i > 0 && i + 1 < polygon.size()) {
      const double w = cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
      sum += w * (polygon[0] + polygon[i] + polygon[i + 1]) / 3.0;
      weight += w;
    }
  }
  return std::abs(weight) > 0 ? sum / weight : mean;
}

Polygon2d clip(const Polygon2d& polygon, glm::dvec2 normal, double offset) {
  Polygon2d result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
    const double da = glm::dot(normal, a) - offset;
    const double db = glm::dot(normal, b) - offset;
    if (da <= 0) {
      result.push_back(a);
    }
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
      result.push_back(a + (b - a) * (da / (da - db)));
    }
  }
  return result.size() < 3 ? Polygon2d{} : result;
}

Polygon2d intersect(const Polygon2d& a, const Polygon2d& b) {
  Polygon2d result = a;
  for (std::size_t i = 0; i < b.size() && !result.empty(); ++i) {
    const glm::dvec2 edge = b[(i + 1) % b.size()] - b[i];
    const glm::dvec2 outward(edge.y, -edge.x);
    result = clip(result, outward, glm::dot(outward, b[i]));
  }
  return result;
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/reference/contour.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

constexpr double kTwoPi = 6.283185307179586;
/// Sine of the elevation over the polygon's plane below which a point counts as lying in it.
constexpr double kEdgeOn = 1e-12;

/// One edge of the contour, seen from the origin.
double edge_term(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normal) {
  const glm::dvec3 wedge = glm::cross(a, b);
  const double sine = glm::length(wedge);
  if (sine == 0.0) {
    return 0.0;
  }
  // atan2 keeps its accuracy for very small and very large angles, where acos of the dot product loses it.
  return std::atan2(sine, glm::dot(a, b)) * glm::dot(wedge, normal) / sine;
}

bool is_in_front(const glm::dvec3& point, const std::vector<glm::dvec3>& polygon) {
  glm::dvec3 area{0.0};
  double reach = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    area += glm::cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  }
  for (const glm::dvec3& corner : polygon) {
    reach = std::max(reach, glm::length(corner - point));
  }
  return glm::dot(area, point - polygon[0]) > kEdgeOn * glm::length(area) * reach;
}

/// Sums the terms of a contour, edge by edge, as clipped to the horizon.
class ClippedContour {
 public:
  explicit ClippedContour(const glm::dvec3& normal) : normal_(normal) {}

  void add_edge(const glm::dvec3& a, const glm::dvec3& b) {
    const double height_a = glm::dot(a, normal_);
    const double height_b = glm::dot(b, normal_);
    if (height_a > 0.0 && height_b > 0.0) {
      sum_ += edge_term(a, b, normal_);
    } else if (height_a > 0.0) {
      exit_ = a + (b - a) * (height_a / (height_a - height_b));
      has_exit_ = true;
      sum_ += edge_term(a, exit_, normal_);
    } else if (height_b > 0.0) {
      const glm::dvec3 rise = b + (a - b) * (height_b / (height_b - height_a));
      enter(rise);
      sum_ += edge_term(rise, b, normal_);
    }
  }

  double sum() const { return has_entry_ && has_exit_ ? sum_ + edge_term(exit_, entry_, normal_) : sum_; }

 private:
  /// Along the horizon, from where the contour sank to where it rises.
  void enter(const glm::dvec3& rise) {
    if (has_exit_) {
      sum_ += edge_term(exit_, rise, normal_);
      has_exit_ = false;
    } else {
      entry_ = rise;  // the contour began below: closed at the end
      has_entry_ = true;
    }
  }

  glm::dvec3 normal_;
  glm::dvec3 entry_{0.0};
  glm::dvec3 exit_{0.0};
  bool has_entry_ = false;
  bool has_exit_ = false;
  double sum_ = 0.0;
};

}  // namespace

double point_to_polygon(const glm::dvec3& point, const glm::dvec3& normal,
                        const std::vector<glm::dvec3>& polygon) {
  if (polygon.size() < 3 || !is_in_front(point, polygon)) {
    return 0.0;
  }
  ClippedContour contour(normal);
  glm::dvec3 a = polygon.back() - point;
  for (const glm::dvec3& corner : polygon) {
    const glm::dvec3 b = corner - point;
    contour.add_edge(a, b);
    a = b;
  }
  // Seen from its lit side the contour runs clockwise about the line of sight: hence the sign.
  return std::clamp(-contour.sum() / kTwoPi, 0.0, 1.0);
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "tests/meshing/direct_light.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/reference/contour.h"

namespace fixrad::host {
namespace {

constexpr double kInPlane = 1e-3;  // grid units

using Corners = std::vector<glm::dvec3>;

/// The part of a convex polygon where normal . (p - on) <= 0.
Corners cut(const Corners& polygon, const glm::dvec3& normal, const glm::dvec3& on) {
  Corners kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double at_p = glm::dot(normal, p - on), at_q = glm::dot(normal, q - on);
    if (at_p <= 0) {
      kept.push_back(p);
    }
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
  }
  return kept.size() >= 3 ? kept : Corners{};
}

}  // namespace

DirectLight::DirectLight(const PreparedScene& scene) {
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    Corners corners;
    for (const std::uint32_t v : scene.faces[f].corners) {
      corners.emplace_back(scene.vertices.positions[v]);
    }
    faces_.push_back(corners);
    normals_.push_back(scene.faces[f].normal);
    if (scene.model->materials[scene.faces[f].material].emission != glm::dvec3(0.0)) {
      lamps_.push_back(f);
    }
  }
}

// A blocker's shadow from the point is bounded by the planes through the point and its edges, and by its own
// plane.
void DirectLight::hide(const Corners& blocker, const glm::dvec3& point, std::vector<Corners>& seen) const {
  glm::dvec3 normal = glm::normalize(glm::cross(blocker[1] - blocker[0], blocker[2] - blocker[0]));
  const double height = glm::dot(normal, point - blocker[0]);
  if (std::abs(height) <= kInPlane) {
    return;
  }
  const double turn = height > 0 ? 1.0 : -1.0;
  normal *= turn;
  std::vector<Corners> rest;
  for (const Corners& lamp : seen) {
    const auto keep = [&](const Corners& part) {
      if (!part.empty()) {
        rest.push_back(part);
      }
    };
    keep(cut(lamp, -normal, blocker[0]));
    Corners hidden = cut(lamp, normal, blocker[0]);
    for (std::size_t k = 0; k < blocker.size() && !hidden.empty(); ++k) {
      const glm::dvec3 edge =
          turn * glm::cross(blocker[k] - point, blocker[(k + 1) % blocker.size()] - point);
      keep(cut(hidden, -edge, point));
      hidden = cut(hidden, edge, point);
    }
  }
  seen.swap(rest);
}

double DirectLight::form_factor(std::uint32_t face, const glm::dvec3& point) const {
  double sum = 0;
  for (const std::uint32_t lamp : lamps_) {
    std::vector<Corners> seen{faces_[lamp]};
    for (std::uint32_t f = 0; f < faces_.size() && !seen.empty(); ++f) {
      if (f != face && f != lamp) {
        hide(faces_[f], point, seen);
      }
    }
    for (const Corners& part : seen) {
      sum += point_to_polygon(point, normals_[face], part);
    }
  }
  return sum;
}

double DirectLight::unhidden(std::uint32_t face, const glm::dvec3& point) const {
  double sum = 0;
  for (const std::uint32_t lamp : lamps_) {
    sum += point_to_polygon(point, normals_[face], faces_[lamp]);
  }
  return sum;
}

}  // namespace fixrad::host

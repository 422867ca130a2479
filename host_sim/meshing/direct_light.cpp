// SPDX-License-Identifier: MIT
#include "host_sim/meshing/direct_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInPlane = 1e-3;  // grid units
constexpr double kEdgeOn = 1e-6;   // cosine

using Corners = std::vector<glm::dvec3>;

/// The part of a convex polygon where normal . (p - on) <= 0.
Corners cut(const Corners& polygon, const glm::dvec3& normal, const glm::dvec3& on) {
  Corners kept;
  kept.reserve(polygon.size() + 1);
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

bool is_all_beyond(const Corners& polygon, const glm::dvec3& normal, const glm::dvec3& on) {
  return std::all_of(polygon.begin(), polygon.end(),
                     [&](const glm::dvec3& p) { return glm::dot(normal, p - on) >= 0; });
}

/// Form factor from a point to a polygon above its horizon.
double contour(const glm::dvec3& point, const glm::dvec3& normal, const Corners& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3 a = polygon[k] - point, b = polygon[(k + 1) % polygon.size()] - point;
    const glm::dvec3 wedge = glm::cross(b, a);
    const double sine = glm::length(wedge);
    sum += sine > 0 ? std::atan2(sine, glm::dot(a, b)) * glm::dot(wedge, normal) / sine : 0.0;
  }
  return std::clamp(sum / (2 * kPi), 0.0, 1.0);
}

/// Whether a line through `point` along `way` meets the polygon: which way it turns round each edge.
bool meets(const Corners& polygon, double turn, const glm::dvec3& point, const glm::dvec3& way) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3 a = polygon[k] - point, b = polygon[(k + 1) % polygon.size()] - point;
    if (turn * glm::dot(way, glm::cross(a, b)) < 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

DirectLight::DirectLight(const PreparedScene& scene, std::size_t most_lamps) {
  std::vector<double> flux;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    Corners corners;
    for (const std::uint32_t v : scene.faces[f].corners) {
      corners.emplace_back(scene.vertices.positions[v]);
    }
    Ball ball = {scene.frames[f].height, 0.0};
    for (const glm::dvec3& corner : corners) {
      ball.radius = std::max(ball.radius, glm::distance(corner, ball.middle));
    }
    balls_.push_back(ball);
    faces_.push_back(corners);
    normals_.push_back(scene.faces[f].normal);
    const glm::dvec3 emission = scene.model->materials[scene.faces[f].material].emission;
    const double exitance = channel_sum(emission) / 3;
    flux.push_back(exitance * area(scene.frames[f].outline) * scene.frames[f].unit_area());
    if (exitance > 0) {
      lamps_.push_back({f, exitance});
    }
  }
  std::stable_sort(lamps_.begin(), lamps_.end(),
                   [&](const Lamp& a, const Lamp& b) { return flux[a.face] > flux[b.face]; });
  lamps_.resize(std::min(lamps_.size(), most_lamps));
}

// Whether the ball round a face reaches into the cone from the point to the ball round a lamp.
bool DirectLight::may_hide(std::uint32_t blocker, std::uint32_t lamp, const glm::dvec3& point) const {
  const glm::dvec3 way = balls_[lamp].middle - point, aside = balls_[blocker].middle - point;
  const double along = std::clamp(glm::dot(way, aside) / std::max(1.0, glm::dot(way, way)), 0.0, 1.0);
  const glm::dvec3 off = aside - along * way;
  const double reach = balls_[blocker].radius + balls_[lamp].radius;
  return glm::dot(off, off) <= reach * reach;
}

// What a blocker hides lies behind its plane and between the planes through the point and its edges.
void DirectLight::hide(std::uint32_t blocker, const glm::dvec3& point, std::vector<Corners>& seen) const {
  const Corners& corners = faces_[blocker];
  const double height = glm::dot(normals_[blocker], point - corners[0]);
  if (std::abs(height) <= kInPlane) {
    return;
  }
  const double turn = height > 0 ? 1.0 : -1.0;
  const glm::dvec3 towards = turn * normals_[blocker];
  if (std::all_of(seen.begin(), seen.end(),
                  [&](const Corners& part) { return is_all_beyond(part, towards, corners[0]); })) {
    return;
  }
  std::vector<std::pair<glm::dvec3, glm::dvec3>> planes;
  planes.reserve(corners.size() + 1);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    planes.emplace_back(turn * glm::cross(corners[k] - point, corners[(k + 1) % corners.size()] - point),
                        point);
  }
  planes.emplace_back(towards, corners[0]);
  std::vector<Corners> rest;
  for (Corners& part : seen) {
    const bool is_free = std::any_of(planes.begin(), planes.end(), [&](const auto& plane) {
      return is_all_beyond(part, plane.first, plane.second);
    });
    if (is_free) {
      rest.push_back(std::move(part));
      continue;
    }
    Corners hidden = std::move(part);
    for (std::size_t k = 0; k < planes.size() && !hidden.empty(); ++k) {
      Corners outside = cut(hidden, -planes[k].first, planes[k].second);
      if (!outside.empty()) {
        rest.push_back(std::move(outside));
      }
      hidden = cut(hidden, planes[k].first, planes[k].second);
    }
  }
  seen.swap(rest);
}

bool DirectLight::is_buried(std::uint32_t face, const glm::dvec3& point) const {
  const glm::dvec3 up = normals_[face];
  double nearest = std::numeric_limits<double>::infinity();
  bool is_back = false;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const double rise = glm::dot(normals_[f], up);
    const double height = glm::dot(normals_[f], faces_[f][0] - point);
    if (f != face && std::abs(rise) > kEdgeOn && height * rise > 0 && height / rise < nearest &&
        meets(faces_[f], rise > 0 ? 1.0 : -1.0, point, up)) {
      nearest = height / rise;
      is_back = rise > 0;
    }
  }
  return is_back;
}

double DirectLight::sum(std::uint32_t face, const glm::dvec3& point, bool is_hidden) const {
  double sum = 0;
  for (const Lamp& lamp : lamps_) {
    if (glm::dot(normals_[lamp.face], point - faces_[lamp.face][0]) <= 0) {
      continue;
    }
    const Corners above = cut(faces_[lamp.face], -normals_[face], point);
    std::vector<Corners> seen;
    if (!above.empty()) {
      seen.push_back(above);
    }
    for (std::uint32_t f = 0; f < faces_.size() && is_hidden && !seen.empty(); ++f) {
      if (f != face && f != lamp.face && may_hide(f, lamp.face, point) &&
          !is_all_beyond(faces_[f], -normals_[face], point)) {
        hide(f, point, seen);
      }
    }
    for (const Corners& part : seen) {
      sum += lamp.exitance * contour(point, normals_[face], part);
    }
  }
  return sum;
}

}  // namespace fixrad::host

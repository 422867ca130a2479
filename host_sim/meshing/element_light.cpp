// SPDX-License-Identifier: MIT
#include "host_sim/meshing/element_light.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace fixrad::host {
namespace {

constexpr std::size_t kMostLamps = 16;
constexpr double kLift = 0.25;  // grid units that points stand off their face
constexpr double kTurn = 6.283185307179586;
constexpr int kRing = 3;         // points round a corner
constexpr double kRadius = 2.0;  // grid units
constexpr double kTouch = 0.75;  // grid units; as the displayed mesh joins corners

double twice_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

glm::dvec2 spread_point(const Polygon2d& polygon, std::uint32_t i) {
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
  const double whole = std::fmod(0.5 + kFirst * (i + 1), 1.0) * area(polygon);
  double v = std::fmod(0.5 + kSecond * (i + 1), 1.0);
  double before = 0, u = 0;
  std::size_t k = 1;
  for (; k + 1 < polygon.size(); ++k) {
    const double part = twice_area(polygon[0], polygon[k], polygon[k + 1]) / 2;
    u = part > 0 ? std::clamp((whole - before) / part, 0.0, 1.0) : 0.0;
    if (whole <= before + part || k + 2 == polygon.size()) {
      break;
    }
    before += part;
  }
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return polygon[0] + u * (polygon[k] - polygon[0]) + v * (polygon[k + 1] - polygon[0]);
}

bool contains(const Polygon2d& polygon, glm::dvec2 p) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    if (twice_area(polygon[k], polygon[(k + 1) % polygon.size()], p) < 0) {
      return false;
    }
  }
  return true;
}

bool insert_on_sides(const FaceFrame& frame, Polygon2d& border, const Polygon2d& points) {
  Polygon2d result;
  for (std::size_t k = 0; k < border.size(); ++k) {
    const glm::dvec2 a = border[k], b = border[(k + 1) % border.size()];
    const glm::dvec3 start = frame.to_grid(a), side = frame.to_grid(b) - start;
    const double length = glm::length(side);
    std::vector<std::pair<double, glm::dvec2>> inner;
    for (const glm::dvec2 p : points) {
      const glm::dvec3 d = frame.to_grid(p) - start;
      const double along = glm::dot(d, side) / std::max(length, 1e-9);
      const bool is_known = std::any_of(inner.begin(), inner.end(), [&](const auto& known) {
        return std::abs(known.first - along) < kTouch;
      });
      if (along > kTouch && along < length - kTouch && !is_known &&
          glm::length(d - side * (along / length)) < kTouch) {
        inner.emplace_back(along, p);
      }
    }
    std::sort(inner.begin(), inner.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    result.push_back(a);
    for (const auto& [along, p] : inner) {
      result.push_back(p);
    }
  }
  const bool is_changed = result.size() > border.size();
  border.swap(result);
  return is_changed;
}

std::vector<std::array<std::size_t, 3>> fan_of(const Polygon2d& polygon) {
  const std::size_t n = polygon.size();
  std::size_t best = 0;
  double largest = -1;
  for (std::size_t s = 0; s < n; ++s) {
    double smallest = 4 * area(polygon);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      smallest = std::min(smallest, twice_area(polygon[s], polygon[(s + i) % n], polygon[(s + i + 1) % n]));
    }
    if (smallest > largest) {
      largest = smallest;
      best = s;
    }
  }
  std::vector<std::array<std::size_t, 3>> fan;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    fan.push_back({best, (best + i) % n, (best + i + 1) % n});
  }
  return fan;
}

ElementLight::ElementLight(const PreparedScene& scene, const LightWeights& weights)
    : scene_(scene), light_(scene, kMostLamps), weights_(weights), corners_(scene.faces.size()) {
  double emitted = 0, absorbing = 0;
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    const Material& material = scene.model->materials[scene.faces[f].material];
    const double face_area = area(scene.frames[f].outline) * scene.frames[f].unit_area();
    scene_area_ += face_area;
    emitted += face_area * glm::dot(material.emission, glm::dvec3(1.0 / 3));
    absorbing += face_area * (1 - glm::dot(material.reflectance, glm::dvec3(1.0 / 3)));
  }
  ambient_ = emitted * (1 / absorbing - 1 / scene_area_);
}

LightSample ElementLight::sample(std::uint32_t face, glm::dvec2 at) const {
  const glm::dvec3 point = scene_.frames[face].to_grid(at) + kLift * scene_.frames[face].normal;
  return {at, light_.irradiance(face, point), light_.is_buried(face, point)};
}

/// What a corner would show: the mean of what is seen round it on its face.
double ElementLight::corner_light(std::uint32_t face, glm::dvec2 corner, glm::dvec2 inside) {
  const auto [known, is_new] = corners_[face].try_emplace({corner.x, corner.y}, 0.0);
  if (!is_new) {
    return known->second;
  }
  const FaceFrame& frame = scene_.frames[face];
  const glm::dvec3 middle = frame.to_grid(corner), x = glm::normalize(glm::dvec3(frame.axis_u));
  const glm::dvec3 y = glm::cross(frame.normal, x);
  double sum = 0;
  int count = 0;
  for (int k = 0; k < kRing; ++k) {
    const double angle = kTurn * (k + 0.3) / kRing;
    const glm::dvec2 at = frame.to_frame(middle + kRadius * (std::cos(angle) * x + std::sin(angle) * y));
    const LightSample seen = contains(frame.outline, at) ? sample(face, at) : LightSample{at, 0.0, true};
    if (!seen.is_buried) {
      sum += seen.light;
      ++count;
    }
  }
  const double reach = glm::distance(middle, frame.to_grid(inside));
  const glm::dvec2 moved = corner + (inside - corner) * std::min(1.0, kRadius / std::max(reach, 1e-9));
  return known->second = count > 0 ? sum / count : sample(face, moved).light;
}

double ElementLight::shading_error(std::uint32_t face, const Polygon2d& border,
                                   const std::vector<LightSample>& samples) {
  const glm::dvec2 middle = centroid(border);
  std::vector<double> light;
  for (const glm::dvec2 corner : border) {
    light.push_back(corner_light(face, corner, middle));
  }
  const std::vector<std::array<std::size_t, 3>> fan = fan_of(border);
  double sum = 0;
  for (const LightSample& s : samples) {
    double most = -1e300, shown = 0;
    for (const auto& [a, b, c] : fan) {
      const double whole = twice_area(border[a], border[b], border[c]);
      if (!(whole > 0)) {
        continue;
      }
      const double of_a = twice_area(s.at, border[b], border[c]) / whole;
      const double of_b = twice_area(border[a], s.at, border[c]) / whole;
      const double inside = std::min({of_a, of_b, 1 - of_a - of_b});
      if (inside > most) {
        most = inside;
        shown = of_a * light[a] + of_b * light[b] + (1 - of_a - of_b) * light[c];
      }
    }
    sum += s.is_buried ? 0.0 : std::abs(s.light - shown);
  }
  return sum;
}

/// A sender stands for its light by its centroid: wrong by about the square of its size over that of the
/// scene.
double ElementLight::sender_error(std::uint32_t face, const Polygon2d& border) const {
  glm::dvec2 low = border[0], high = low;
  for (const glm::dvec2 p : border) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 u(scene_.frames[face].axis_u), v(scene_.frames[face].axis_v);
  const glm::dvec2 squared = (high - low) * (high - low) * glm::dvec2(glm::dot(u, u), glm::dot(v, v));
  return (squared.x + squared.y) / scene_area_;
}

double ElementLight::error_of(std::uint32_t face, const Polygon2d& border,
                              const std::vector<LightSample>& samples) {
  if (samples.empty() || border.size() < 3) {
    return 0;
  }
  double mean = 0, uneven = 0;
  for (const LightSample& s : samples) {
    mean += s.light / static_cast<double>(samples.size());
  }
  for (const LightSample& s : samples) {
    uneven += std::abs(s.light - mean);
  }
  const double sent = static_cast<double>(samples.size()) * (mean + ambient_);
  return shading_error(face, border, samples) + weights_.flat * uneven +
         weights_.sender * sent * sender_error(face, border);
}

}  // namespace fixrad::host

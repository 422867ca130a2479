// SPDX-License-Identifier: MIT
#include "host_sim/reference/path_estimator.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/io/model.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.141592653589793;
/// Roulette begins when the path's weight has sunk to this: the first vertices are worth their rays.
constexpr double kRouletteBelow = 0.5;
/// With more of the area emitting than this, a path meets lamps by itself and looking for them only adds
/// noise.
constexpr double kMostlyLamps = 0.5;

/// A cosine-distributed direction about a unit normal, whose tangents follow from it without a branch on its
/// size (T. Duff et al., JCGT 6(1), 2017).
glm::dvec3 cosine_direction(const glm::dvec3& normal, double u, double v) {
  const double sign = std::copysign(1.0, normal.z);
  const double a = -1.0 / (sign + normal.z);
  const double b = normal.x * normal.y * a;
  const glm::dvec3 tangent{1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
  const glm::dvec3 bitangent{b, sign + normal.y * normal.y * a, -normal.y};
  const double radius = std::sqrt(u);
  const double angle = 2.0 * kPi * v;
  return radius * (std::cos(angle) * tangent + std::sin(angle) * bitangent) + std::sqrt(1.0 - u) * normal;
}

/// cos cos / (pi r^2): the density per lamp area with which a cosine-distributed ray arrives. 0 if facing
/// away.
double point_kernel(const SurfacePoint& p, const glm::dvec3& q, const glm::dvec3& q_normal) {
  const glm::dvec3 sight = q - p.position;
  const double square = glm::dot(sight, sight);
  const double cosines = std::max(0.0, glm::dot(sight, p.normal)) * std::max(0.0, -glm::dot(sight, q_normal));
  return square > 0.0 ? cosines / (kPi * square * square) : 0.0;
}

RayScene ray_scene_of(const std::vector<MeshElement>& polygons,
                      std::vector<std::uint32_t>& surface_of_triangle) {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    const auto corners = static_cast<std::uint32_t>(polygons[i].polygon.size());
    positions.insert(positions.end(), polygons[i].polygon.begin(), polygons[i].polygon.end());
    for (std::uint32_t k = 1; k + 1 < corners; ++k) {
      triangles.insert(triangles.end(), {first, first + k, first + k + 1});
      surface_of_triangle.push_back(i);
    }
  }
  return {positions, triangles};
}

bool survives(glm::dvec3& weight, CounterRandom& random) {
  const double chance = std::max({weight.x, weight.y, weight.z}) / kRouletteBelow;
  if (chance >= 1.0) {
    return true;
  }
  if (random.next() >= chance) {
    return false;
  }
  weight /= chance;
  return true;
}

}  // namespace

PathEstimator::PathEstimator(const std::vector<MeshElement>& polygons)
    : scene_(ray_scene_of(polygons, surface_of_triangle_)) {
  for (const MeshElement& polygon : polygons) {
    surfaces_.push_back({polygon.normal, polygon.centroid, polygon.reflectance, polygon.emission, 0.0});
  }
  find_lamps(polygons);
}

void PathEstimator::find_lamps(const std::vector<MeshElement>& polygons) {
  double total_area = 0.0;
  double lamp_area = 0.0;
  double power = 0.0;
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    total_area += polygons[i].area;
    if (channel_sum(polygons[i].emission) > 0.0) {
      lamp_area += polygons[i].area;
      power += polygons[i].area * channel_sum(polygons[i].emission);
      lamps_.push_back({i, power, PolygonSampler(polygons[i].polygon)});
    }
  }
  asks_lamps_ = !lamps_.empty() && lamp_area < kMostlyLamps * total_area;
  if (asks_lamps_) {
    for (const Lamp& lamp : lamps_) {
      surfaces_[lamp.surface].lamp_density = channel_sum(polygons[lamp.surface].emission) / power;
    }
  }
}

glm::dvec3 PathEstimator::irradiance(SurfacePoint point, const PathSample& sample,
                                     CounterRandom& random) const {
  glm::dvec3 total{0.0};
  glm::dvec3 weight{1.0};
  VertexSample vertex = sample.first;
  for (bool is_first = true;; is_first = false) {
    if (asks_lamps_) {
      total += weight * from_lamp(point, vertex);
    }
    const glm::dvec3 direction = cosine_direction(point.normal, vertex.direction_u, vertex.direction_v);
    const auto hit = scene_.nearest(point.position, point.normal, direction);
    if (!hit || !hit->front) {
      return total;
    }
    const Surface& met = surfaces_[surface_of_triangle_[hit->triangle]];
    glm::dvec3 position = point.position + hit->distance * direction;
    position -= glm::dot(position - met.centroid, met.normal) * met.normal;  // back into its plane, in double
    total += weight * met.emission * share_of_path(point, position, met);
    point = {position, met.normal};
    weight *= met.reflectance;
    if (!survives(weight, random)) {
      return total;
    }
    vertex.direction_u = random.next();
    vertex.direction_v = random.next();
    vertex.lamp_u = is_first ? sample.lamp_u : random.next();
    vertex.lamp_v = is_first ? sample.lamp_v : random.next();
    vertex.lamp = is_first ? sample.lamp : random.next();
  }
}

/// Light from one point of one lamp, over the sum of the densities with which both ways would have chosen it.
glm::dvec3 PathEstimator::from_lamp(const SurfacePoint& point, const VertexSample& sample) const {
  const double wanted = sample.lamp * lamps_.back().power;
  const auto lamp = std::upper_bound(lamps_.begin(), lamps_.end() - 1, wanted,
                                     [](double power, const Lamp& next) { return power < next.power; });
  const Surface& emitter = surfaces_[lamp->surface];
  const glm::dvec3 target = lamp->sampler.sample(sample.lamp_u, sample.lamp_v);
  const double kernel = point_kernel(point, target, emitter.normal);
  if (kernel == 0.0 || !scene_.visible(point.position, point.normal, target, emitter.normal)) {
    return glm::dvec3{0.0};
  }
  return emitter.emission * (kernel / (kernel + emitter.lamp_density));
}

/// The balance heuristic's part for a lamp that the path itself has met.
double PathEstimator::share_of_path(const SurfacePoint& start, const glm::dvec3& met,
                                    const Surface& surface) const {
  if (surface.lamp_density == 0.0) {
    return 1.0;
  }
  const double kernel = point_kernel(start, met, surface.normal);
  return kernel / (kernel + surface.lamp_density);
}

}  // namespace fixrad::host

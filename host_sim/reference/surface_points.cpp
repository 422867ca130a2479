// SPDX-License-Identifier: MIT
#include "host_sim/reference/surface_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/reference/polygon_sampling.h"
#include "host_sim/reference/sobol.h"
#include "host_sim/reference/visibility.h"

namespace fixrad::host {
namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::uint64_t kDirectionSeed = 5;
constexpr int kDirections = 64;
constexpr std::size_t kMostTries = 50;  // a wanted point
constexpr double kTurn = 2 * 3.14159265358979323846;

RayScene rays_of(const std::vector<MeshElement>& polygons) {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> triangles;
  for (const MeshElement& polygon : polygons) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), polygon.polygon.begin(), polygon.polygon.end());
    for (std::uint32_t k = 1; k + 1 < polygon.polygon.size(); ++k) {
      triangles.insert(triangles.end(), {first, first + k, first + k + 1});
    }
  }
  return RayScene(positions, triangles);
}

bool is_buried(const RayScene& rays, const SurfacePoint& point) {
  const glm::dvec3 n = point.normal;
  const glm::dvec3 t =
      glm::normalize(glm::cross(n, std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 b = glm::cross(n, t);
  ScrambledSobol set(kDirectionSeed);
  int backs = 0;
  for (int i = 0; i < kDirections; ++i) {
    const auto x = set.next();
    const double radius = std::sqrt(x[0]), angle = kTurn * x[1];
    const glm::dvec3 direction =
        radius * (std::cos(angle) * t + std::sin(angle) * b) + std::sqrt(1 - x[0]) * n;
    const auto hit = rays.nearest(point.position, n, direction);
    backs += hit && !hit->front ? 1 : 0;
  }
  return 2 * backs > kDirections;
}

}  // namespace

std::vector<SamplePoint> surface_points(const std::vector<MeshElement>& polygons, std::size_t count) {
  const bool all_emit = std::all_of(polygons.begin(), polygons.end(),
                                    [](const MeshElement& p) { return p.emission != glm::dvec3(0.0); });
  std::vector<const MeshElement*> chosen;
  std::vector<double> areas;  // running sum
  for (const MeshElement& polygon : polygons) {
    if (polygon.reflectance != glm::dvec3(0.0) && (all_emit || polygon.emission == glm::dvec3(0.0))) {
      areas.push_back((areas.empty() ? 0.0 : areas.back()) + polygon.area);
      chosen.push_back(&polygon);
    }
  }
  const RayScene rays = rays_of(polygons);
  ScrambledSobol set(kSeed);
  std::vector<SamplePoint> points;
  for (std::size_t i = 0; !chosen.empty() && points.size() < count && i < kMostTries * count; ++i) {
    const auto x = set.next();
    const double at = x[0] * areas.back();
    const auto found = std::upper_bound(areas.begin(), areas.end() - 1, at);
    const double before = found == areas.begin() ? 0.0 : *(found - 1);
    const MeshElement& polygon = *chosen[static_cast<std::size_t>(found - areas.begin())];
    const double within = std::clamp((at - before) / (*found - before), 0.0, 1.0);
    const SurfacePoint point = {sample_polygon(polygon.polygon, within, x[1]), polygon.normal};
    if (!is_buried(rays, point)) {
      points.push_back({point, polygon.reflectance, polygon.emission, polygon.input_face});
    }
  }
  return points;
}

}  // namespace fixrad::host

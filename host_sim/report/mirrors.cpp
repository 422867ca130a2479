// SPDX-License-Identifier: MIT
#include "host_sim/report/mirrors.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Triangles of one plane: cosine between their normals, and distance as a part of the larger offset.
constexpr double kSameNormal = 0.99999;
constexpr double kSameOffset = 1e-3;

MirrorPlane plane_of(const BakedMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const glm::dvec3 p = mesh.positions[a];
  MirrorPlane plane;
  plane.normal = glm::normalize(glm::cross(mesh.positions[b] - p, mesh.positions[c] - p));
  plane.offset = glm::dot(plane.normal, p);
  plane.appearance = mesh.triangle_appearance[triangle];
  return plane;
}

double extent(const BakedMesh& mesh) {
  glm::dvec3 low = mesh.positions.front(), high = low;
  for (const glm::dvec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::length(high - low);
}

}  // namespace

Mirrors find_mirrors(const BakedMesh& mesh) {
  Mirrors mirrors;
  mirrors.of_triangle.assign(mesh.triangles.size(), Mirrors::kNone);
  const double same = kSameOffset * extent(mesh);
  for (std::size_t t = 0; t < mesh.triangle_appearance.size(); ++t) {
    if (!mesh.appearances[mesh.triangle_appearance[t]].is_mirror) {
      continue;
    }
    const MirrorPlane plane = plane_of(mesh, t);
    const auto known = std::find_if(mirrors.planes.begin(), mirrors.planes.end(), [&](const MirrorPlane& m) {
      return m.appearance == plane.appearance && glm::dot(m.normal, plane.normal) > kSameNormal &&
             std::abs(m.offset - plane.offset) < same;
    });
    mirrors.of_triangle[t] = static_cast<std::uint32_t>(known - mirrors.planes.begin());
    if (known == mirrors.planes.end()) {
      mirrors.planes.push_back(plane);
    }
  }
  return mirrors;
}

glm::dvec3 reflected(const MirrorPlane& plane, const glm::dvec3& point) {
  return point - 2.0 * (glm::dot(plane.normal, point) - plane.offset) * plane.normal;
}

glm::dvec3 highlights(const std::vector<BakedLamp>& lamps, const Appearance& appearance,
                      const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& eye) {
  const glm::dvec3 to_eye = glm::normalize(eye - point);
  glm::dvec3 sum(0.0);
  if (appearance.exponent <= 0.0 || glm::dot(normal, to_eye) <= 0.0) {
    return sum;
  }
  const glm::dvec3 mirrored = 2.0 * glm::dot(normal, to_eye) * normal - to_eye;
  for (const BakedLamp& lamp : lamps) {
    const glm::dvec3 way = lamp.position - point;
    const double square = glm::dot(way, way);
    const glm::dvec3 to_lamp = way / std::sqrt(square);
    const double at_surface = glm::dot(normal, to_lamp), at_lamp = -glm::dot(lamp.normal, to_lamp);
    const double lobe = glm::dot(mirrored, to_lamp);
    if (square > 0.0 && at_surface > 0.0 && at_lamp > 0.0 && lobe > 0.0) {
      const double part = std::min(1.0, lamp.area * at_surface * at_lamp / (kPi * square));
      const double n = appearance.exponent;
      sum += (n + 2) / 2 * std::pow(lobe, n) * part * appearance.specular * lamp.radiosity;
    }
  }
  return sum;
}

}  // namespace fixrad::host

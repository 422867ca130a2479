// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "host_sim/report/baked_mesh.h"

namespace fixrad::host {

/// The plane of a flat mirror: the points p with dot(normal, p) = offset.
struct MirrorPlane {
  glm::dvec3 normal{0.0};  ///< unit, towards the lit side
  double offset = 0.0;
  std::uint32_t appearance = 0;
};

/// The mirrors of a mesh: triangles of one mirroring material in one plane.
struct Mirrors {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<MirrorPlane> planes;
  std::vector<std::uint32_t> of_triangle;  ///< [triangles], into planes, or kNone
};

Mirrors find_mirrors(const BakedMesh& mesh);

/// The image of a point in a mirror.
glm::dvec3 reflected(const MirrorPlane& plane, const glm::dvec3& point);

/// What highlights add to the radiosity of a surface seen from `eye`, W/m^2: Ks (n + 2)/2 cos^n(a) E a lamp,
/// see lib/picture/highlight.h. `normal` is a unit vector.
glm::dvec3 highlights(const std::vector<BakedLamp>& lamps, const Appearance& appearance,
                      const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& eye);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// The direct light of a scene's lamps in closed form: what a point sees of each lamp is cut out of the
/// lamp's polygon by planes through the point and the edges of everything between, and Lambert's formula
/// gives the rest.
class DirectLight {
 public:
  explicit DirectLight(const PreparedScene& scene);

  /// Irradiance over the exitance, in [0, 1], if all lamps had the same exitance; `point` in grid units, on
  /// the face.
  double form_factor(std::uint32_t face, const glm::dvec3& point) const;
  /// The same if nothing stood between.
  double unhidden(std::uint32_t face, const glm::dvec3& point) const;

 private:
  using Corners = std::vector<glm::dvec3>;

  void hide(const Corners& blocker, const glm::dvec3& point, std::vector<Corners>& seen) const;

  std::vector<Corners> faces_;
  std::vector<glm::dvec3> normals_;
  std::vector<std::uint32_t> lamps_;
};

}  // namespace fixrad::host

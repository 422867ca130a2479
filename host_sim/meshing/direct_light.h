// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// The direct light of a scene's lamps in closed form. What a point sees of a lamp is cut out of the lamp's
/// polygon by the planes through the point and the edges of everything between (T. Nishita, E. Nakamae,
/// "Half-tone representation of 3-D objects illuminated by area sources", COMPSAC 1983); Lambert's contour
/// formula says what each part gives. Lengths in grid units.
class DirectLight {
 public:
  /// Takes the `most_lamps` faces of most emitted flux as lamps.
  explicit DirectLight(const PreparedScene& scene, std::size_t most_lamps = SIZE_MAX);

  /// W/m^2, mean of the channels, at a point of `face`; faces in whose plane the point lies hide nothing.
  /// Cost: the faces, and the lamp's parts where one is between.
  double irradiance(std::uint32_t face, const glm::dvec3& point) const { return sum(face, point, true); }
  /// The same if nothing stood between.
  double unhidden(std::uint32_t face, const glm::dvec3& point) const { return sum(face, point, false); }
  /// Whether the point is under something that stands on the face: the first that is met along the normal
  /// turns its back. Nobody sees it.
  bool is_buried(std::uint32_t face, const glm::dvec3& point) const;

 private:
  using Corners = std::vector<glm::dvec3>;
  struct Lamp {
    std::uint32_t face;
    double exitance;
  };
  struct Ball {
    glm::dvec3 middle;
    double radius;
  };

  double sum(std::uint32_t face, const glm::dvec3& point, bool is_hidden) const;
  bool may_hide(std::uint32_t blocker, std::uint32_t lamp, const glm::dvec3& point) const;
  void hide(std::uint32_t blocker, const glm::dvec3& point, std::vector<Corners>& seen) const;

  std::vector<Corners> faces_;
  std::vector<glm::dvec3> normals_;
  std::vector<Ball> balls_;  // round the faces
  std::vector<Lamp> lamps_;
};

}  // namespace fixrad::host

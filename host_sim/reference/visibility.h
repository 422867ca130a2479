// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace fixrad::host {

/// What a ray meets first.
struct RayHit {
  std::uint32_t triangle = 0;  ///< index of the triangle, in the order given
  double distance = 0.0;       ///< along the ray, scene units
  bool front = false;          ///< whether the side is met from which its corners run counter-clockwise
};

/// Triangles that block light from both sides, ready for rays (Embree, single precision inside, so the scene
/// is first moved and scaled into the unit cube). Queries are const and may run on any number of threads.
///
/// End points are taken to lie on surfaces: each is lifted off by kLift of the scene's size along its normal,
/// so that neither rounding nor contact with the own plane makes a surface block itself.
class RayScene {
 public:
  /// Lift of an end point over half the longest edge of the scene's box: some twenty units of single
  /// precision.
  static constexpr double kLift = 2e-6;

  /// @param positions  scene units
  /// @param triangles  three indices into positions a triangle; may be empty, nothing blocks then
  /// @throws std::runtime_error when Embree cannot be set up, or when an index is out of range
  RayScene(const std::vector<glm::dvec3>& positions, const std::vector<std::uint32_t>& triangles);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Whether nothing stands between two surface points. Normals: unit, of the side that looks at the other
  /// point.
  bool visible(const glm::dvec3& p, const glm::dvec3& p_normal, const glm::dvec3& q,
               const glm::dvec3& q_normal) const;

  /// visible() for up to kPacket pairs of points on two surfaces at once, which costs less than half as much.
  /// @param p, q   [count] scene units
  /// @return bit k is set where nothing stands between p[k] and q[k]
  std::uint32_t visible_packet(const glm::dvec3* p, const glm::dvec3& p_normal, const glm::dvec3* q,
                               const glm::dvec3& q_normal, std::size_t count) const;
  static constexpr std::size_t kPacket = 8;

  /// The first triangle in a direction (unit) from a surface point; nothing when the ray leaves the scene.
  /// Where two triangles lie back to back in one plane (a two-sided sheet), it is the one that turns its
  /// front.
  std::optional<RayHit> nearest(const glm::dvec3& origin, const glm::dvec3& normal,
                                const glm::dvec3& direction) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fixrad::host

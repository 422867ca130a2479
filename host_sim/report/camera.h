// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace fixrad::host {

/// A pinhole camera. Its picture is upright with respect to the scene's up axis.
struct Camera {
  glm::dvec3 eye{0.0};         ///< scene unit
  glm::dvec3 target{0.0};      ///< in the middle of the picture; differs from eye
  double vertical_fov = 39.3;  ///< full angle from the lower to the upper edge, degrees, in (0, 180)
};

/// The scene's up axis: +y, or +z for --up z.
glm::dvec3 up_axis(bool z_up);

/// Right-handed orthonormal axes of a view. `forward` is a unit vector; where it is parallel to up, the
/// picture's upper edge points along another axis of the scene.
struct ViewAxes {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 forward;
};
ViewAxes view_axes(const glm::dvec3& forward, bool z_up);

/// Projects points of the scene onto a picture of a given size.
class Projection {
 public:
  /// Throws std::invalid_argument if the camera has eye = target, an angle out of range, or numbers not
  /// finite.
  Projection(const Camera& camera, bool z_up, int width, int height);

  /// Scene to camera: x to the right, y up, z the distance along the view, in the scene's unit.
  glm::dvec3 to_camera(const glm::dvec3& point) const;

  /// The point at `distance` along the view that appears at `pixels`.
  glm::dvec3 to_scene(const glm::dvec2& pixels, double distance) const;

  /// Sees from behind a mirror what the mirror shows: the points p with dot(normal, p) = offset.
  Projection mirrored(const glm::dvec3& normal, double offset) const;
  bool is_mirrored() const { return is_mirrored_; }
  const glm::dvec3& eye() const { return eye_; }

  /// Camera (z > 0) to picture, in pixels: (0, 0) is the upper left corner of the picture, x to the right, y
  /// down.
  glm::dvec2 to_pixels(const glm::dvec3& in_camera) const;

 private:
  glm::dvec3 eye_;
  ViewAxes axes_;
  double pixels_per_tangent_;
  glm::dvec2 centre_;
  bool is_mirrored_ = false;
};

}  // namespace fixrad::host

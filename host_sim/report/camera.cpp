// SPDX-License-Identifier: MIT
#include "host_sim/report/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

namespace fixrad::host {
namespace {

/// Sine of the angle between view and up axis under which they count as parallel.
constexpr double kParallel = 1e-6;

double checked_tangent(const Camera& camera) {
  const double distance = glm::length(camera.target - camera.eye);
  if (!std::isfinite(distance) || distance <= 0.0) {
    throw std::invalid_argument("camera: eye and target must be two different finite points");
  }
  if (!(camera.vertical_fov > 0.0 && camera.vertical_fov < 180.0)) {
    throw std::invalid_argument("camera: the field of view must be between 0 and 180 degrees");
  }
  return std::tan(glm::radians(camera.vertical_fov) / 2.0);
}

}  // namespace

glm::dvec3 up_axis(bool z_up) {
  return z_up ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
}

ViewAxes view_axes(const glm::dvec3& forward, bool z_up) {
  glm::dvec3 right = glm::cross(forward, up_axis(z_up));
  if (glm::length(right) < kParallel) {
    right = glm::dvec3(1.0, 0.0, 0.0);
  }
  right = glm::normalize(right);
  return {right, glm::cross(right, forward), forward};
}

Projection::Projection(const Camera& camera, bool z_up, int width, int height)
    : eye_(camera.eye),
      axes_{},
      pixels_per_tangent_(0.5 * height / checked_tangent(camera)),
      centre_(0.5 * width, 0.5 * height) {
  axes_ = view_axes(glm::normalize(camera.target - camera.eye), z_up);
}

glm::dvec3 Projection::to_camera(const glm::dvec3& point) const {
  const glm::dvec3 d = point - eye_;
  return {glm::dot(d, axes_.right), glm::dot(d, axes_.up), glm::dot(d, axes_.forward)};
}

glm::dvec3 Projection::to_scene(const glm::dvec2& pixels, double distance) const {
  const glm::dvec2 tangent = (pixels - centre_) / pixels_per_tangent_;
  return eye_ + distance * (axes_.forward + tangent.x * axes_.right - tangent.y * axes_.up);
}

Projection Projection::mirrored(const glm::dvec3& normal, double offset) const {
  const auto turned = [&](const glm::dvec3& v) { return v - 2.0 * glm::dot(normal, v) * normal; };
  Projection image = *this;
  image.eye_ = turned(eye_) + 2.0 * offset * normal;
  image.axes_ = {turned(axes_.right), turned(axes_.up), turned(axes_.forward)};
  image.is_mirrored_ = !is_mirrored_;
  return image;
}

glm::dvec2 Projection::to_pixels(const glm::dvec3& in_camera) const {
  const double scale = pixels_per_tangent_ / in_camera.z;
  return {centre_.x + scale * in_camera.x, centre_.y - scale * in_camera.y};
}

}  // namespace fixrad::host

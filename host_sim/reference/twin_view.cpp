// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_view.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

// The core's rules: a plane within two grid units of the eye counts as seen from the front, and a plane
// through the eye is as far as the core's smallest distance.
constexpr double kEdgeOn = 2.0 * kEyeScale;
constexpr double kSmallestDistance = 1.0 / kUnit;

struct Frame {
  glm::dvec3 x, y, z;

  glm::dvec3 to_local(const glm::dvec3& v) const { return {glm::dot(x, v), glm::dot(y, v), glm::dot(z, v)}; }
};

// Angle i of the core's sequence is frac((i + 1/2) / golden ratio) of a half turn.
Frame make_frame(const TwinFace& face, int turn) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr double kHalfTurn = 3.14159265358979323846;
  const double steps = (turn % kTurns + 0.5) * kGolden;
  const double angle = (steps - std::floor(steps)) * kHalfTurn;
  const glm::dvec3 x = face.tangent;
  const glm::dvec3 y = glm::cross(face.normal, x);
  return {x * std::cos(angle) + y * std::sin(angle), y * std::cos(angle) - x * std::sin(angle), face.normal};
}

bool is_below_horizon(const TwinScene& scene, const TwinFace& face,
                      const std::vector<glm::dvec3>& directions) {
  for (std::uint32_t k = 0; k < face.corner_count; ++k) {
    if (directions[scene.corners[face.first_corner + k]].z > 0) {
      return false;
    }
  }
  return true;
}

// With o the grid's origin seen from the eye and u, v its axes, a direction d meets the plane where d t = o +
// a u + b v, hence a = (o x v) . d / (v x u) . d and b = (u x o) . d / (v x u) . d.
void make_grid(const TwinFace& face, const Frame& frame, const glm::dvec3& eye, TwinFaceView& view) {
  const glm::dvec3 o = frame.to_local(face.origin - eye);
  const glm::dvec3 u = frame.to_local(face.axis_u);
  const glm::dvec3 v = frame.to_local(face.axis_v);
  view.grid_u = glm::cross(o, v) * static_cast<double>(face.cells_u);
  view.grid_v = glm::cross(u, o) * static_cast<double>(face.cells_v);
  view.grid_n = glm::cross(v, u);
}

}  // namespace

void make_twin_view(const TwinScene& scene, const EyePoint& eye, Backs backs, TwinView& view) {
  const Frame frame = make_frame(scene.faces[eye.face], eye.turn);
  const glm::dvec3 position(eye.position.x, eye.position.y, eye.position.z);
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
    view.directions[i] = frame.to_local(scene.vertices[i] - position);
  }
  view.count = 0;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const TwinFace& face = scene.faces[f];
    const double height = glm::dot(face.normal, position - scene.vertices[scene.corners[face.first_corner]]);
    const bool is_back = height < -kEdgeOn;
    const bool is_left_out =
        is_back && (backs == Backs::none || (backs == Backs::unsealed && face.is_sealed));
    if (f == eye.face || is_left_out || is_below_horizon(scene, face, view.directions)) {
      continue;
    }
    TwinFaceView& seen = view.faces[view.count++];
    seen.face = f;
    seen.is_back = is_back;
    const double distance = is_back ? -height : height;
    const double scale = (is_back ? 1.0 : -1.0) / (distance > 0 ? distance : kSmallestDistance);
    seen.plane = frame.to_local(face.normal) * scale;
    if (!is_back && (face.cells_u * face.cells_v > 1 || !scene.roots.empty())) {
      make_grid(face, frame, position, seen);
    }
  }
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "lib/scene/shape.h"

#include "lib/scene/corner.h"

namespace fixrad {
namespace {

// How often the directed edge a -> b occurs, less how often b -> a does.
int edge_balance(const Scene& scene, uint16_t a, uint16_t b) {
  int balance = 0;
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face face = flash_read(scene.faces, f);
    uint16_t from = corner_vertex(scene, face, face.corner_count - 1);
    for (int k = 0; k < face.corner_count; ++k) {
      const uint16_t to = corner_vertex(scene, face, k);
      balance += from == a && to == b ? 1 : 0;
      balance -= from == b && to == a ? 1 : 0;
      from = to;
    }
  }
  return balance;
}

// Six times the signed volume under the faces, positive for bodies seen from outside. A term is at most 2
// kGridMax^3 < 2^43, and there are fewer than 2^19.
int64_t signed_volume(const Scene& scene) {
  int64_t sum = 0;
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face face = flash_read(scene.faces, f);
    const Vec3 a = corner_position(scene, face, 0);
    for (int k = 1; k + 1 < face.corner_count; ++k) {
      sum += turn_about(corner_position(scene, face, k), corner_position(scene, face, k + 1), a);
    }
  }
  return sum;
}

// How far a point lies before the plane of a face, Q14 grid units: an offset of 15 bits with its sign times a
// unit vector stays below 2^29.
int32_t corner_height(const Scene& scene, const Face& face, Vec3 point) {
  return dot(vec(face.normal), point - corner_position(scene, face, 0));
}

constexpr int32_t kHeightTolerance = kPlaneTolerance * kUnit;

bool is_in_plane(const Scene& scene, const Face& face, const Face& other) {
  for (int k = 0; k < other.corner_count; ++k) {
    const int32_t height = corner_height(scene, face, corner_position(scene, other, k));
    if (height > kHeightTolerance || height < -kHeightTolerance) {
      return false;
    }
  }
  return true;
}

// Has `face` an edge with all of `other` on its far side, but for kPlaneTolerance?
bool has_edge_between(const Scene& scene, const Face& face, const Face& other) {
  for (int k = 0; k < face.corner_count; ++k) {
    const Vec3 a = corner_position(scene, face, k);
    const Vec3 along = corner_position(scene, face, k + 1) - a;
    const int64_t slack = static_cast<int64_t>(kHeightTolerance) * max_magnitude(along);
    bool is_between = true;
    for (int i = 0; i < other.corner_count && is_between; ++i) {
      is_between = turn_about(along, corner_position(scene, other, i) - a, vec(face.normal)) <= slack;
    }
    if (is_between) {
      return true;
    }
  }
  return false;
}

bool is_before(const Scene& scene, const Face& face, Vec3 point) {
  return corner_height(scene, face, point) >= -kHeightTolerance;
}

// Two layers in one plane, the upper of which hides the lower.
bool are_layers(const Scene& scene, const Face& a, const Face& b) {
  return dot(vec(a.normal), vec(b.normal)) > 0 && is_in_plane(scene, a, b) &&
         !has_edge_between(scene, a, b) && !has_edge_between(scene, b, a);
}

}  // namespace

bool is_convex(const Scene& scene) {
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face face = flash_read(scene.faces, f);
    for (uint16_t v = 0; v < scene.vertex_count; ++v) {
      if (!is_before(scene, face, vec(flash_read(scene.vertices, v)))) {
        return false;
      }
    }
  }
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face face = flash_read(scene.faces, f);
    for (uint16_t g = 0; g < f; ++g) {
      if (are_layers(scene, face, flash_read(scene.faces, g))) {
        return false;
      }
    }
  }
  return true;
}

bool is_closed(const Scene& scene) {
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face face = flash_read(scene.faces, f);
    uint16_t from = corner_vertex(scene, face, face.corner_count - 1);
    for (int k = 0; k < face.corner_count; ++k) {
      const uint16_t to = corner_vertex(scene, face, k);
      if (edge_balance(scene, from, to) != 0) {
        return false;
      }
      from = to;
    }
  }
  return scene.face_count > 0;
}

bool is_enclosed(const Scene& scene) {
  return is_closed(scene) && signed_volume(scene) < 0;
}

}  // namespace fixrad

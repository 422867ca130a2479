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

}  // namespace

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

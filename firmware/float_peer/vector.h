// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/scene/scene.h"

namespace fixrad {
namespace peer {

struct Vector {
  float x, y, z;
};

inline Vector scale(Vector a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}

inline Vector add(Vector a, Vector b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline float dot(Vector a, Vector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Grid coordinates are subtracted as the integers that they are; what is left is converted once.
inline Vector to_float(Vec3 a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

}  // namespace peer
}  // namespace fixrad

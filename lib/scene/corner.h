// SPDX-License-Identifier: MIT
#pragma once

#include "lib/scene/scene.h"

namespace fixrad {

/// a . b, where it does not fit 32 bits.
inline int64_t wide_dot(const int64_t (&a)[3], Vec3 b) {
  return a[0] * b.x + a[1] * b.y + a[2] * b.z;
}

/// (b x c) . n; no overflow, since differences of grid points have 15 bits.
inline int64_t turn_about(Vec3 b, Vec3 c, Vec3 n) {
  const int64_t x[3] = {static_cast<int64_t>(b.y) * c.z - static_cast<int64_t>(b.z) * c.y,
                        static_cast<int64_t>(b.z) * c.x - static_cast<int64_t>(b.x) * c.z,
                        static_cast<int64_t>(b.x) * c.y - static_cast<int64_t>(b.y) * c.x};
  return wide_dot(x, n);
}

/// Position of corner `k` of `face`, any k >= 0: they go round. Grid units.
inline Vec3 corner_position(const Scene& scene, const Face& face, int k) {
  return vec(flash_read(scene.vertices, corner_vertex(scene, face, k % face.corner_count)));
}

}  // namespace fixrad

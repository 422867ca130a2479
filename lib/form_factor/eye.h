// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/scene/scene.h"

namespace fixrad {

/// A point that a patch is seen from: position in quarters of a grid unit, lifted off its face.
struct EyePoint {
  Vec3 position;
  uint16_t face;
  uint8_t turn;  ///< which of the fixed angles the axes are turned by, modulo kTurns
};

constexpr int kTurns = 16;

/// Which backs of faces take part in a view: they block and are black.
enum class Backs : uint8_t { none, unsealed, all };

/// The view's axes in grid space, Q14, |v| < 16,391; z is the normal of the face, rows run along x.
struct EyeFrame {
  Vec3 x, y, z;
};

/// The face's tangent and normal, turned about the normal by the `turn`-th angle of a fixed sequence
/// (golden-ratio steps through the half turn). Without it, errors of axis-aligned rows add up from shot to
/// shot.
EyeFrame eye_frame(const Face& face, uint8_t turn);

/// A vector in grid space (components up to 2^16) seen in the frame: Q14 times its unit, |result| < 2^31.
inline Vec3 to_local(const EyeFrame& frame, Vec3 v) {
  return {dot(frame.x, v), dot(frame.y, v), dot(frame.z, v)};
}

}  // namespace fixrad

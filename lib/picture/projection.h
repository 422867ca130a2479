// SPDX-License-Identifier: MIT
#pragma once

#include "lib/picture/records.h"

namespace fixrad {

/// Positions seen by a camera: 1/16 grid unit.
constexpr int kViewBits = 4;
/// Positions in a picture: 1/256 pixel, y down.
constexpr int kPixelBits = 8;
/// Nothing is seen nearer than this along the view: 4 grid units.
constexpr int32_t kNearest = 4 << kViewBits;
/// 1/distance: 2^37 a 1/16 grid unit, so 2^31 at kNearest.
constexpr int kInverseBits = 37;

/// A corner on its way into the picture.
struct ViewCorner {
  Vec3 at;                       ///< camera axes, 1/16 grid unit; z is the distance along the view
  uint16_t light[kMaxChannels];  ///< UQ4.12
  int16_t normal[3];             ///< Q14, of the scene; read for highlights only
};

struct ScreenCorner {
  int32_t x, y;      ///< 1/256 pixel, y down
  uint32_t inverse;  ///< 1/distance, 2^37 a 1/16 grid unit
};

/// A camera as vertices are seen by it; mirrored ones have left-handed axes.
struct Projection {
  Vec3 eye;                 ///< grid units
  Vec3 right, up, forward;  ///< Q14
  uint32_t focal;           ///< UQ13.8 pixels
  uint16_t width, height;
  uint32_t guard_x, guard_y;  ///< tangents beyond which triangles are cut off, UQ12.12
  bool is_mirrored;
};

Projection projection_of(const PictureCamera& camera);

/// The camera that sees from behind the mirror what the mirror shows. False if its eye is out of range.
bool mirrored(const Projection& camera, const PictureMirror& mirror, Projection& result);

/// Height of a vertex of the scene over the mirror's plane, Q14 grid units.
int32_t height_over(const PictureMirror& mirror, Vec3 point);

/// `vertex`, grid units, in the camera's axes, 1/16 grid unit, rounded to nearest.
Vec3 to_view(const Projection& projection, Vec3 vertex);

/// `view`, 1/16 grid unit, back in the scene's axes: grid units.
Vec3 to_grid(const Projection& projection, Vec3 view);

/// Where `view` (z >= kNearest, within the guard) appears. Cost: a 64-bit division.
ScreenCorner to_screen(const Projection& projection, Vec3 view);

}  // namespace fixrad

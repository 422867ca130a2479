// SPDX-License-Identifier: MIT
#pragma once

#include "lib/picture/projection.h"

namespace fixrad {

/// Depths: 4 grid units along the view; 0 and kFarthest stand for no surface.
constexpr int kDepthBits = 2;
constexpr uint16_t kFarthest = 0x7fff;

/// Where in its triangle a pixel lies, seen in space and not in the picture.
struct SurfacePoint {
  uint16_t depth;         ///< 1 .. kFarthest - 1
  int32_t second, third;  ///< weights of the corners, Q14, >= 0; the first has the rest, >= 0 too
};

/// Perspective-correct interpolation (Blinn 1992, "Hyperbolic interpolation"): the three weights times
/// 1/distance are linear in the picture, so along a row each is a sum; one division a pixel gives weights and
/// depth. Numbers that leave 32 bits outside the triangle return within it, modulo 2^32.
class TriangleShading {
 public:
  /// `area` = screen_area(a, b, c) > 0. Cost: 12 products of 64 bits.
  TriangleShading(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c, int64_t area);

  /// Goes to a pixel.
  void start(int32_t x, int32_t y);
  /// Goes to the next pixel of the row.
  void step();
  /// Of the pixel's centre; it lies in the triangle.
  SurfacePoint point() const;

 private:
  struct Weight {
    uint32_t at_reference, by_column, by_row, value;
  };
  void set(Weight& weight, const ScreenCorner& from, const ScreenCorner& to, uint32_t inverse);

  Weight weight_[3];
  int32_t reference_x_, reference_y_;
  int area_shift_;    // of screen_area, so that it has 31 bits
  int weight_shift_;  // of the products, so that they have 28 bits
  uint32_t area_;     // its top 16 bits
  int depth_shift_;
};

/// a + second (b - a) + third (c - a), rounded; values of 16 bits and a sign.
inline int32_t interpolate(const SurfacePoint& point, int32_t a, int32_t b, int32_t c) {
  return a + rounded_shift((b - a) * point.second + (c - a) * point.third, 14);
}

/// The same for values of 32 bits.
inline int32_t interpolate_wide(const SurfacePoint& point, int32_t a, int32_t b, int32_t c) {
  const int64_t way =
      (static_cast<int64_t>(b) - a) * point.second + (static_cast<int64_t>(c) - a) * point.third;
  return a + static_cast<int32_t>((way + (1l << 13)) >> 14);
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include "lib/picture/projection.h"

namespace fixrad {

/// A triangle has three corners, and one more for each plane that cuts it: near, four sides, a mirror.
constexpr int kMaxViewCorners = 9;

/// A convex polygon.
struct ViewPolygon {
  ViewCorner corner[kMaxViewCorners];
  uint8_t count;
};

/// Cuts off where `distance` [count] is negative (Sutherland & Hodgman 1974). A cut is computed from the end
/// that stays to the one that goes, so triangles that share a side share its cut. `from` and `to` differ.
/// Cost: a 64-bit division a cut.
void clip(const ViewPolygon& from, const int32_t* distance, ViewPolygon& to);

/// What of `polygon` lies beyond kNearest and within the guard of the picture; false if nothing.
bool clip_to_view(const Projection& projection, ViewPolygon& polygon);

}  // namespace fixrad

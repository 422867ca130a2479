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

/// Cuts off where `distance` [count] is negative, which is so for some corners and not for all. In place, and
/// the distances are turned with the corners: there is no room for a second polygon on a small chip's stack.
/// A cut is computed from the end that stays to the one that goes, so triangles that share a side share its
/// cut. Cost: two 64-bit divisions.
void clip(ViewPolygon& polygon, int32_t* distance);

/// What of `polygon` lies beyond kNearest and within the guard of the picture; false if nothing.
bool clip_to_view(const Projection& projection, ViewPolygon& polygon);

}  // namespace fixrad

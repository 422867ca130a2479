// SPDX-License-Identifier: MIT
#include "lib/picture/clip.h"

namespace fixrad {
namespace {

constexpr int kPartBits = 24;

int32_t between(int32_t from, int32_t to, int32_t part) {
  const int64_t half = static_cast<int64_t>(1) << (kPartBits - 1);
  return from + static_cast<int32_t>(((static_cast<int64_t>(to) - from) * part + half) >> kPartBits);
}

// Where the distance, negative at `gone` only, is zero.
ViewCorner cut(const ViewCorner& kept, int32_t kept_distance, const ViewCorner& gone, int32_t gone_distance) {
  const int64_t whole = static_cast<int64_t>(kept_distance) - gone_distance;
  const int32_t part = static_cast<int32_t>((static_cast<int64_t>(kept_distance) << kPartBits) / whole);
  ViewCorner result;
  result.at = {between(kept.at.x, gone.at.x, part), between(kept.at.y, gone.at.y, part),
               between(kept.at.z, gone.at.z, part)};
  for (int c = 0; c < kMaxChannels; ++c) {
    result.light[c] = narrow<uint16_t>(between(kept.light[c], gone.light[c], part), Place::clipped_light);
    result.normal[c] = narrow<int16_t>(between(kept.normal[c], gone.normal[c], part), Place::clipped_normal);
  }
  return result;
}

// The first corner becomes the last.
void turn(ViewPolygon& polygon, int32_t* distance) {
  const ViewCorner corner = polygon.corner[0];
  const int32_t first = distance[0];
  for (uint8_t i = 1; i < polygon.count; ++i) {
    polygon.corner[i - 1] = polygon.corner[i];
    distance[i - 1] = distance[i];
  }
  polygon.corner[polygon.count - 1] = corner;
  distance[polygon.count - 1] = first;
}

constexpr uint8_t kViewPlanes = 5;
constexpr int32_t kMost = 0x7fffffff;

// Signed distance from a plane of the view: 0 near, 1 and 2 left and right, 3 and 4 below and above.
int32_t view_distance(const Projection& projection, uint8_t plane, Vec3 at) {
  if (plane == 0) {
    return at.z - kNearest;
  }
  const uint32_t tangent = plane < 3 ? projection.guard_x : projection.guard_y;
  const int32_t across = plane < 3 ? at.x : at.y;
  const int64_t limit = (static_cast<int64_t>(at.z) * tangent) >> 12;
  const int64_t distance = (plane & 1) != 0 ? limit + across : limit - across;
  return distance > kMost ? kMost : static_cast<int32_t>(distance);
}

}  // namespace

void clip(ViewPolygon& polygon, int32_t* distance) {
  const uint8_t count = polygon.count;
  while (distance[0] >= 0 || distance[count - 1] < 0) {
    turn(polygon, distance);
  }
  uint8_t kept = 1;
  while (distance[kept] < 0) {
    ++kept;
  }
  const uint8_t last = static_cast<uint8_t>(count - 1), before = static_cast<uint8_t>(kept - 1);
  const ViewCorner leaving = cut(polygon.corner[last], distance[last], polygon.corner[0], distance[0]);
  polygon.corner[0] = cut(polygon.corner[kept], distance[kept], polygon.corner[before], distance[before]);
  polygon.count = 1;
  for (uint8_t i = kept; i < count; ++i) {
    polygon.corner[polygon.count++] = polygon.corner[i];
  }
  if (polygon.count < kMaxViewCorners) {
    polygon.corner[polygon.count++] = leaving;
  }
}

bool clip_to_view(const Projection& projection, ViewPolygon& polygon) {
  for (uint8_t plane = 0; plane < kViewPlanes; ++plane) {
    int32_t distance[kMaxViewCorners];
    uint8_t gone = 0;
    for (uint8_t i = 0; i < polygon.count; ++i) {
      distance[i] = view_distance(projection, plane, polygon.corner[i].at);
      gone = static_cast<uint8_t>(gone + (distance[i] < 0 ? 1 : 0));
    }
    if (gone == polygon.count) {
      return false;
    }
    if (gone > 0) {
      clip(polygon, distance);
    }
  }
  return polygon.count >= 3;
}

}  // namespace fixrad

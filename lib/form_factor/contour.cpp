// SPDX-License-Identifier: MIT
#include "lib/form_factor/contour.h"

namespace fixrad {
namespace {

// Offsets of corners are taken in 2^-8 of the polygons' unit: 2^28 along an axis, 2^28.8 in all, so that the
// points where edges meet the horizon keep their direction even near the eye.
constexpr int kOffsetBits = 8;

constexpr uint32_t kInverseTwoPi = 683565276;  // 2^32 / (2 pi)

struct SeenCorner {
  Vec3 offset;
  int32_t height;  // over the horizon, unit of the offset
};

SeenCorner see_corner(const ContourPoint& point, const Vec3& corner) {
  const Vec3 d = corner - point.position;
  const int64_t height = static_cast<int64_t>(point.normal.x) * d.x +
                         static_cast<int64_t>(point.normal.y) * d.y +
                         static_cast<int64_t>(point.normal.z) * d.z;
  constexpr int32_t kFactor = 1 << kOffsetBits;
  return {{d.x * kFactor, d.y * kFactor, d.z * kFactor},
          static_cast<int32_t>(height >> (kArcBits - kOffsetBits))};
}

int32_t on_way(int32_t a, int32_t b, int32_t part, int32_t whole) {
  return a + static_cast<int32_t>(static_cast<int64_t>(b - a) * part / whole);
}

// Where the edge from `above` to `below` meets the horizon, as a direction. Always computed downwards: two
// polygons that share the edge get the same point.
Vec3 horizon_point(const SeenCorner& above, const SeenCorner& below) {
  const int32_t whole = above.height - below.height;
  return unit_vector({on_way(above.offset.x, below.offset.x, above.height, whole),
                      on_way(above.offset.y, below.offset.y, above.height, whole),
                      on_way(above.offset.z, below.offset.z, above.height, whole)});
}

// Adds up the edges of a contour and closes it along the horizon. The part above the horizon is a convex
// polygon on the sphere: its sides are at most 2 pi long in all, so no partial sum passes 2 pi < 8.
class ContourSum {
 public:
  explicit ContourSum(const Vec3& normal) : normal_(normal) {}

  void add(const Vec3& a, const Vec3& b) { sum_ += edge_term(a, b, normal_); }

  void leave(const Vec3& from, const Vec3& horizon) {
    add(from, horizon);
    exit_ = horizon;
    has_exit_ = true;
  }

  void enter(const Vec3& horizon, const Vec3& to) {
    if (has_exit_) {
      add(exit_, horizon);
      has_exit_ = false;
    } else {
      entry_ = horizon;
      has_entry_ = true;
    }
    add(horizon, to);
  }

  // Seen from its front a contour runs clockwise about the line of sight: hence the sign.
  int32_t factor() {
    if (has_exit_ && has_entry_) {
      add(exit_, entry_);
    }
    const int32_t part =
        static_cast<int32_t>(wide_product(magnitude(sum_), kInverseTwoPi) >> (32 + kAngleBits - kArcBits));
    const int32_t bounded = part < kArcOne ? part : kArcOne;
    return sum_ > 0 ? -bounded : bounded;
  }

 private:
  const Vec3& normal_;
  Vec3 entry_ = {0, 0, 0}, exit_ = {0, 0, 0};
  int32_t sum_ = 0;
  bool has_entry_ = false, has_exit_ = false;
};

}  // namespace

ContourPoint contour_point(const Face& face, Vec3 position) {
  return {position, unit_vector(vec(face.normal))};
}

int32_t contour_factor(const ContourPoint& point, const Polygon& polygon) {
  if (polygon.count < 3) {
    return 0;
  }
  ContourSum contour(point.normal);
  SeenCorner a = see_corner(point, polygon.corner[polygon.count - 1]);
  Vec3 direction_a = a.height > 0 ? unit_vector(a.offset) : Vec3{0, 0, 0};
  for (int k = 0; k < polygon.count; ++k) {
    const SeenCorner b = see_corner(point, polygon.corner[k]);
    const Vec3 direction_b = b.height > 0 ? unit_vector(b.offset) : Vec3{0, 0, 0};
    if (a.height > 0 && b.height > 0) {
      contour.add(direction_a, direction_b);
    } else if (a.height > 0) {
      contour.leave(direction_a, horizon_point(a, b));
    } else if (b.height > 0) {
      contour.enter(horizon_point(b, a), direction_b);
    }
    a = b;
    direction_a = direction_b;
  }
  return contour.factor();
}

}  // namespace fixrad

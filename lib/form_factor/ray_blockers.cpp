// SPDX-License-Identifier: MIT
#include "lib/form_factor/ray_blockers.h"

namespace fixrad {
namespace {

// A grid unit over a plane, in Q14 times the unit of polygons.
constexpr int64_t kRayTouch = static_cast<int64_t>(kFineScale) * kUnit;

Vec3 fine_corner(const Scene& scene, const Face& face, int k) {
  const Vec3 v = vec(flash_read(scene.vertices, corner_vertex(scene, face, k)));
  return {v.x * kFineScale, v.y * kFineScale, v.z * kFineScale};
}

struct RayPlane {
  Vec3 normal, point;

  RayPlane(const Scene& scene, const Face& face)
      : normal(vec(face.normal)), point(fine_corner(scene, face, 0)) {}

  int64_t height(const Vec3& p) const {
    const Vec3 d = p - point;
    return static_cast<int64_t>(normal.x) * d.x + static_cast<int64_t>(normal.y) * d.y +
           static_cast<int64_t>(normal.z) * d.z;
  }
};

// On which sides of a plane points have been seen.
struct PlaneSides {
  bool above = false, below = false;

  void see(int64_t height) {
    above = above || height > kRayTouch;
    below = below || height < -kRayTouch;
  }
};

PlaneSides sides_of_face(const Scene& scene, const RayPlane& plane, const Face& face) {
  PlaneSides sides;
  for (int k = 0; k < face.corner_count; ++k) {
    sides.see(plane.height(fine_corner(scene, face, k)));
  }
  return sides;
}

// Six times the volume between the ray `d` and the edge a -> b, seen from its start: its sign tells on which
// side of the edge the ray passes. Offsets are below sqrt(3) 2^20, so it is below 2^62.4.
int64_t passing_side(const Vec3& a, const Vec3& b, const Vec3& d) {
  const int64_t x = static_cast<int64_t>(a.y) * b.z - static_cast<int64_t>(a.z) * b.y;
  const int64_t y = static_cast<int64_t>(a.z) * b.x - static_cast<int64_t>(a.x) * b.z;
  const int64_t z = static_cast<int64_t>(a.x) * b.y - static_cast<int64_t>(a.y) * b.x;
  return x * d.x + y * d.y + z * d.z;
}

}  // namespace

void RayBlockers::enter_source(uint16_t face, const Polygon& source) {
  source_ = &source;
  source_face_ = face;
  source_count_ = target_count_ = 0;
  const RayPlane plane(scene_, flash_read(scene_.faces, face));
  for (uint16_t f = 0; f < scene_.face_count; ++f) {
    if (f != face && sides_of_face(scene_, plane, flash_read(scene_.faces, f)).above) {
      work_.views[source_count_++].face = f;
    }
  }
}

void RayBlockers::enter_target(uint16_t face) {
  const Face target = flash_read(scene_.faces, face);
  const RayPlane target_plane(scene_, target);
  target_count_ = 0;
  for (uint16_t i = 0; i < source_count_; ++i) {
    const uint16_t f = work_.views[i].face;
    if (f == face) {
      continue;
    }
    const Face blocker = flash_read(scene_.faces, f);
    const PlaneSides of_target = sides_of_face(scene_, target_plane, blocker);
    const RayPlane plane(scene_, blocker);
    PlaneSides sides = sides_of_face(scene_, plane, target);
    for (int k = 0; k < source_->count; ++k) {
      sides.see(plane.height(source_->corner[k]));
    }
    if ((of_target.above || of_target.below) && sides.above && sides.below) {
      work_.views[target_count_++].first_corner = f;
    }
  }
}

bool RayBlockers::blocks(uint16_t index, const Vec3& from, const Vec3& to) const {
  const Face face = flash_read(scene_.faces, index);
  const RayPlane plane(scene_, face);
  const int64_t begin = plane.height(from), end = plane.height(to);
  const bool crosses = (begin > kRayTouch && end < -kRayTouch) || (begin < -kRayTouch && end > kRayTouch);
  if (!crosses) {
    return false;
  }
  const Vec3 way = to - from;
  bool left = false, right = false;
  Vec3 a = fine_corner(scene_, face, face.corner_count - 1) - from;
  for (int k = 0; k < face.corner_count && !(left && right); ++k) {
    const Vec3 b = fine_corner(scene_, face, k) - from;
    const int64_t side = passing_side(a, b, way);
    left = left || side > 0;
    right = right || side < 0;
    a = b;
  }
  return !(left && right);
}

bool RayBlockers::is_blocked(const Vec3& from, const Vec3& to) {
  for (uint16_t i = 0; i < target_count_; ++i) {
    const uint16_t face = work_.views[i].first_corner;
    if (blocks(face, from, to)) {
      work_.views[i].first_corner = work_.views[0].first_corner;
      work_.views[0].first_corner = face;
      return true;
    }
  }
  return false;
}

}  // namespace fixrad

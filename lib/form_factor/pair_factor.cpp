// SPDX-License-Identifier: MIT
#include "lib/form_factor/pair_factor.h"

namespace fixrad {
namespace {

// Abscissae of Gauss's rule of two points on [0, 1], 1/2 -+ 1/sqrt(12), UQ0.16.
constexpr uint16_t kGaussLow = 0x3619, kGaussHigh = 0xc9e7;

// By half a grid unit along a normal in Q14.
int32_t lift_along(int16_t normal) {
  return rounded_shift(normal * (kFineScale / 2), 14);
}

// The element's polygon, made in place: a copy would be 148 bytes of stack.
const Polygon& make_lifted(const Scene& scene, const Face& face, const ElementCells& cells,
                           Polygon& polygon) {
  element_polygon(scene, face, cells, polygon);
  for (int k = 0; k < polygon.count; ++k) {
    Vec3& p = polygon.corner[k];
    p = {p.x + lift_along(face.normal[0]), p.y + lift_along(face.normal[1]),
         p.z + lift_along(face.normal[2])};
  }
  return polygon;
}

}  // namespace

AreaSource::AreaSource(const Scene& scene, const Face& face, const ElementCells& cells)
    : normal_(unit_vector(vec(face.normal))), points_(make_lifted(scene, face, cells, polygon_)) {}

Vec3 AreaSource::point(int i) const {
  return points_.at((i & 1) != 0 ? kGaussHigh : kGaussLow, (i & 2) != 0 ? kGaussHigh : kGaussLow);
}

int32_t AreaSource::factor(const Polygon& target) const {
  int32_t sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const int32_t part = contour_factor({point(i), normal_}, target);
    sum += (part > 0 ? part : 0) / kPoints;
  }
  return sum;
}

uint32_t AreaSource::free_rays(const Polygon& target, int log2, uint32_t pair, RayBlockers& blockers) const {
  const uint32_t all = static_cast<uint32_t>(1) << log2;
  if (blockers.is_free()) {
    return all;
  }
  const AreaPoints ends(target);
  uint32_t free = 0;
  for (uint32_t i = 0; i < all; ++i) {
    const RayCoordinates ray = ray_coordinates(static_cast<int>(i), log2, pair);
    free += blockers.is_blocked(points_.at(ray.from_s, ray.from_t), ends.at(ray.to_s, ray.to_t)) ? 0u : 1u;
  }
  return free;
}

}  // namespace fixrad

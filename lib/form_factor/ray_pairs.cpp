// SPDX-License-Identifier: MIT
#include "lib/form_factor/ray_pairs.h"

namespace fixrad {

RayPairs::RayPairs(const Scene& scene, const EyeSample& sample, int log2, Workspace& work)
    : scene_(scene),
      sample_(sample),
      log2_(log2),
      face_(flash_read(scene.faces, sample.eye.face)),
      eye_(contour_point(face_, fine_point(sample.eye.position))),
      cells_(cells_at(scene, face_, eye_.position)),
      source_(scene, face_, cells_),
      blockers_(scene, work) {
  blockers_.enter_source(sample.eye.face, source_.polygon());
}

// Distances squared and areas, both in square grid units.
bool RayPairs::is_near(uint16_t index) const {
  if (sample_.weight != kRowOne) {
    return false;
  }
  const Element& element = flash_at(scene_.elements, index);
  const uint32_t own = flash_at(scene_.elements, cells_.element).area;
  const Vec3 way = scale_down(vec(element.eye) - sample_.eye.position, 2);
  const uint64_t distance2 = wide_product(magnitude(way.x), magnitude(way.x)) +
                             wide_product(magnitude(way.y), magnitude(way.y)) +
                             wide_product(magnitude(way.z), magnitude(way.z));
  return distance2 < 4 * ((element.area > own ? element.area : own) / 8);
}

FIXRAD_MODULO uint32_t RayPairs::free_rays(uint16_t slot, const Polygon& target) {
  const uint32_t pair =
      slot ^ (static_cast<uint32_t>(cells_.element) << 16) ^ (sample_.eye.turn * 0x9e3779b9ul);
  return source_.free_rays(target, log2_, pair, blockers_);
}

}  // namespace fixrad

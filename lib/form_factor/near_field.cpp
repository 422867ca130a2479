// SPDX-License-Identifier: MIT
#include "lib/form_factor/near_field.h"

#include "lib/form_factor/pair_factor.h"
#include "lib/form_factor/row_balance.h"

namespace fixrad {
namespace {

constexpr int kNearRaysLog2 = 3;

// Near: distance^2 < larger area / 4. Areas have eighths of a square grid unit, distances quarters of a unit:
// 16 distance^2 < 16 area / (8 * 4).
constexpr int kNearAreaShift = 1;

uint32_t area_of_source(const Scene& scene, const EyeSource& source) {
  uint32_t area = 0;
  for (uint16_t i = 0; i < source.count; ++i) {
    area += flash_at(scene.elements, source_element(scene, source, i)).area;
  }
  return area;
}

class NearPairs {
 public:
  NearPairs(const Scene& scene, const EyeSource& source, Workspace& work, FormFactorRow& row)
      : scene_(scene),
        source_(source),
        row_(row),
        face_(flash_read(scene.faces, source.face)),
        area_(area_of_source(scene, source)),
        blockers_(scene, work) {}

  // True if any pair is near.
  bool mark() {
    bool any = false;
    for (uint16_t j = 0; j < row_.count; ++j) {
      if (is_near(j)) {
        row_.share[j] = kFixedShare;
        any = true;
      }
    }
    return any;
  }

  // Adds what element `i` of the source sends to the marked elements.
  void add_from(uint16_t i) {
    const uint16_t from = source_element(scene_, source_, i);
    const AreaSource source(scene_, face_, cells_of(scene_, face_, from));
    blockers_.enter_source(source_.face, source.polygon());
    entered_ = source_.face;
    for (uint16_t j = 0; j < row_.count; ++j) {
      if ((row_.share[j] & kFixedShare) != 0) {
        row_.share[j] += pair_share(source, from, j);
      }
    }
  }

 private:
  bool is_near(uint16_t j) const {
    const Element& element = flash_at(scene_.elements, j);
    const uint32_t larger = element.area > area_ ? element.area : area_;
    const Vec3 way = vec(element.eye) - vec(source_.centre);
    const uint64_t distance2 = wide_product(magnitude(way.x), magnitude(way.x)) +
                               wide_product(magnitude(way.y), magnitude(way.y)) +
                               wide_product(magnitude(way.z), magnitude(way.z));
    return element.face != source_.face && distance2 < (larger >> kNearAreaShift) &&
           dot(vec(flash_at(scene_.faces, element.face).normal), way) < 0;
  }

  // Both ways the exchange is area x factor; this is the share of all that the source sends.
  uint32_t pair_share(const AreaSource& source, uint16_t from, uint16_t j) {
    const Element to = flash_read(scene_.elements, j);
    const Face face = flash_read(scene_.faces, to.face);
    const ElementCells cells = cells_of(scene_, face, j);
    Polygon target;
    element_polygon(scene_, face, cells, target);
    if (entered_ != to.face) {
      blockers_.enter_target(to.face);
      entered_ = to.face;
    }
    const uint32_t own_area = flash_at(scene_.elements, from).area;
    const bool is_smaller = own_area <= to.area;
    const int32_t factor =
        is_smaller ? source.factor(target) : AreaSource(scene_, face, cells).factor(source.polygon());
    const uint32_t pair = j ^ static_cast<uint32_t>(from) << 16;
    const uint32_t free = source.free_rays(target, kNearRaysLog2, pair, blockers_);
    const uint32_t seen =
        (static_cast<uint32_t>(factor) >> (kArcBits - kDeltaSumLog2)) * free >> kNearRaysLog2;
    return static_cast<uint32_t>(wide_product(seen, is_smaller ? own_area : to.area) / area_);
  }

  const Scene& scene_;
  const EyeSource& source_;
  FormFactorRow& row_;
  Face face_;
  uint32_t area_;
  RayBlockers blockers_;
  uint16_t entered_ = 0;  // the target, or the source's own face for none
};

}  // namespace

void correct_near_field(const Scene& scene, const EyeSource& source, Workspace& work, FormFactorRow& row) {
  NearPairs pairs(scene, source, work, row);
  if (!pairs.mark()) {
    return;
  }
  for (uint16_t i = 0; i < source.count; ++i) {
    pairs.add_from(i);
  }
  balance_row(row, kRowOne);
}

}  // namespace fixrad

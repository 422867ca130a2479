// SPDX-License-Identifier: MIT
#include "lib/form_factor/near_field.h"

#include "lib/form_factor/engine.h"
#include "lib/form_factor/pair_factor.h"
#include "lib/form_factor/row_balance.h"

namespace fixrad {
namespace {

constexpr int kNearRaysLog2 = 3;

// Near: distance^2 < larger area / 4. Areas have eighths of a square grid unit, distances quarters of a unit:
// 16 distance^2 < 16 area / (8 * 4).
constexpr int kNearAreaShift = 1;

class NearPairs {
 public:
  NearPairs(const Scene& scene, uint16_t from, Workspace& work, FormFactorRow& row)
      : scene_(scene),
        from_(from),
        work_(work),
        row_(row),
        own_(flash_read(scene.elements, from)),
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

  // Adds what the element sends to the marked ones, from the one on that the view has come to. False if the
  // budget ends before.
  bool add_pairs() {
    const Face face = flash_read(scene_.faces, own_.face);
    const AreaSource source(scene_, face, cells_of(scene_, face, from_));
    blockers_.enter_source(own_.face, source.polygon());
    entered_ = own_.face;
    for (uint16_t& j = work_.at.elements; j < row_.count; ++j) {
      if ((row_.share[j] & kFixedShare) == 0) {
        continue;
      }
      if (is_used_up(work_)) {
        return false;
      }
      row_.share[j] += pair_share(source, j);
      spend(work_);
    }
    return true;
  }

 private:
  bool is_near(uint16_t j) const {
    const Element& element = flash_at(scene_.elements, j);
    const uint32_t larger = element.area > own_.area ? element.area : own_.area;
    const Vec3 way = vec(element.eye) - vec(own_.eye);
    const uint64_t distance2 = wide_product(magnitude(way.x), magnitude(way.x)) +
                               wide_product(magnitude(way.y), magnitude(way.y)) +
                               wide_product(magnitude(way.z), magnitude(way.z));
    return element.face != own_.face && distance2 < (larger >> kNearAreaShift) &&
           dot(vec(flash_at(scene_.faces, element.face).normal), way) < 0;
  }

  // Both ways the exchange is area x factor; this is the share of all that the source sends.
  uint32_t pair_share(const AreaSource& source, uint16_t j) {
    const Element to = flash_read(scene_.elements, j);
    const Face face = flash_read(scene_.faces, to.face);
    const ElementCells cells = cells_of(scene_, face, j);
    Polygon target;
    element_polygon(scene_, face, cells, target);
    if (entered_ != to.face) {
      blockers_.enter_target(to.face);
      entered_ = to.face;
    }
    const bool is_smaller = own_.area <= to.area;
    const int32_t factor =
        is_smaller ? source.factor(target) : AreaSource(scene_, face, cells).factor(source.polygon());
    const uint32_t pair = j ^ static_cast<uint32_t>(from_) << 16;
    const uint32_t free = source.free_rays(target, kNearRaysLog2, pair, blockers_);
    const uint32_t seen =
        (static_cast<uint32_t>(factor) >> (kArcBits - kDeltaSumLog2)) * free >> kNearRaysLog2;
    return is_smaller ? seen : static_cast<uint32_t>(wide_product(seen, to.area) / own_.area);
  }

  const Scene& scene_;
  uint16_t from_;
  Workspace& work_;
  FormFactorRow& row_;
  Element own_;
  RayBlockers blockers_;
  uint16_t entered_ = 0;  // the target, or the source's own face for none
};

}  // namespace

Status correct_near_field(const Scene& scene, uint16_t element, Workspace& work, FormFactorRow& row) {
  if (is_used_up(work)) {
    return Status::in_progress;
  }
  NearPairs pairs(scene, element, work, row);
  if (work.at.next == 0) {
    const bool any = pairs.mark();
    spend(work);
    if (!any) {
      return Status::ok;
    }
    work.at.next = 1;
  }
  if (is_used_up(work) || !pairs.add_pairs()) {
    return Status::in_progress;
  }
  balance_row(row, kRowOne);
  return end_view(work, Status::ok);
}

}  // namespace fixrad

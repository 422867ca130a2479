// SPDX-License-Identifier: MIT
#include "lib/form_factor/direct_light.h"

#include "lib/form_factor/area_points.h"
#include "lib/form_factor/contour.h"
#include "lib/form_factor/ray_blockers.h"
#include "lib/form_factor/row_balance.h"

namespace fixrad {
namespace {

constexpr int kLampShift = kArcBits - kDeltaSumLog2;

// Lamps that give less than this part of all direct light stay as sampled.
constexpr uint64_t kFaintLamp = 256;
// A ray decides on at most this part of all direct light, as far as kMaxRaysLog2 allows.
constexpr uint64_t kLightOfRay = 64;

// Lamps that coincide hide nothing of each other; balance_row() takes sums below 4. Q30.
constexpr uint32_t kMostLight = 3ul << kArcBits;

// Sum of the channels, a quarter, so that it fits.
uint32_t emission_of(const Scene& scene, const Face& face) {
  const Material material = flash_read(scene.materials, face.material);
  uint32_t sum = 0;
  for (int c = 0; c < scene.channels; ++c) {
    sum += material.emission[c] >> 2;
  }
  return sum;
}

// Direct light if nothing hides it, below 2^46: those of all faces fit 64 bits, 64 times one too.
uint64_t light_of(int32_t factor, uint32_t emission) {
  return factor <= 0 ? 0 : wide_product(static_cast<uint32_t>(factor), emission) >> 16;
}

class LampsInRow {
 public:
  LampsInRow(const Scene& scene, const EyePoint& eye, Workspace& work, FormFactorRow& row)
      : scene_(scene),
        turn_(eye.turn),
        point_(contour_point(flash_read(scene.faces, eye.face), fine_point(eye.position))),
        row_(row),
        blockers_(scene, work) {
    source_.corner[0] = point_.position;
    source_.count = 1;
    blockers_.enter_source(eye.face, source_);
  }

  // Of all lamps, if nothing hid them.
  void add_up() {
    for (uint16_t f = 0; f < scene_.face_count; ++f) {
      const Face face = flash_read(scene_.faces, f);
      const uint32_t emission = emission_of(scene_, face);
      all_ += emission == 0 ? 0 : light_of(whole_factor(face), emission);
    }
  }

  // True if entries have been replaced.
  bool add_face(uint16_t index) {
    const Face face = flash_read(scene_.faces, index);
    const uint32_t emission = emission_of(scene_, face);
    const int32_t whole = emission == 0 ? 0 : whole_factor(face);
    if (whole <= 0 || whole > kArcOne / kLargeLamp || light_of(whole, emission) < all_ / kFaintLamp) {
      return false;
    }
    blockers_.enter_target(index);
    Polygon target;
    for (ElementCellWalk walk(scene_, face); walk.next();) {
      const uint16_t element = walk.cells().element;
      element_polygon(scene_, face, walk.cells(), target);
      const int32_t factor = contour_factor(point_, target);
      const int log2 = rays_log2(light_of(factor, emission));
      row_.share[element] = kFixedShare | next_share(factor <= 0 ? 0 : static_cast<uint32_t>(factor) >> log2,
                                                     free_rays(element, target, log2));
    }
    return true;
  }

 private:
  int32_t whole_factor(const Face& face) const {
    Polygon outline;
    face_outline(scene_, face, outline);
    return contour_factor(point_, outline);
  }

  int rays_log2(uint64_t light) const {
    int log2 = 0;
    while (log2 < kMaxRaysLog2 && (all_ << log2) < kLightOfRay * light) {
      ++log2;
    }
    return log2;
  }

  // Of 2^log2.
  FIXRAD_MODULO uint32_t free_rays(uint16_t element, const Polygon& target, int log2) {
    const uint32_t rays = static_cast<uint32_t>(1) << log2;
    if (blockers_.is_free()) {
      return rays;
    }
    const AreaPoints ends(target);
    const uint32_t pair = element ^ turn_ * 0x9e3779b9ul;
    uint32_t free = 0;
    for (uint32_t i = 0; i < rays; ++i) {
      const RayCoordinates ray = ray_coordinates(static_cast<int>(i), log2, pair);
      free += blockers_.is_blocked(point_.position, ends.at(ray.to_s, ray.to_t)) ? 0u : 1u;
    }
    return free;
  }

  // Sums are rounded, not entries: small elements of a lamp lose nothing.
  uint32_t next_share(uint32_t factor_of_ray, uint32_t rays) {
    const uint32_t before = rounded();
    const uint32_t part = factor_of_ray * rays;
    sum_ = part < kMostLight - sum_ ? sum_ + part : kMostLight;
    return rounded() - before;
  }
  uint32_t rounded() const { return (sum_ + (static_cast<uint32_t>(1) << (kLampShift - 1))) >> kLampShift; }

  const Scene& scene_;
  uint32_t turn_;
  ContourPoint point_;
  Polygon source_;
  FormFactorRow& row_;
  RayBlockers blockers_;
  uint64_t all_ = 0;
  uint32_t sum_ = 0;
};

}  // namespace

void correct_direct_light(const Scene& scene, const EyePoint& eye, Workspace& work, FormFactorRow& row) {
  LampsInRow lamps(scene, eye, work, row);
  lamps.add_up();
  bool any = false;
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    any = lamps.add_face(f) || any;
  }
  if (any) {
    balance_row(row, kRowOne);
  }
}

}  // namespace fixrad

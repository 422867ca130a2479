// SPDX-License-Identifier: MIT
#include "lib/form_factor/engine.h"
#include "lib/form_factor/ray_pairs.h"
#include "lib/form_factor/row_balance.h"

namespace fixrad {
namespace {

// Running sums stay below 4, in Q30.
constexpr uint32_t kRaySumLimit = 0xfffffffful;

// A closed scene seen from inside loses nothing; what rounding leaves uncovered on rows is less than this.
constexpr uint32_t kRayGap = kRowOne >> 8;

// One eye's row: the factors of the pairs, times the part of their rays that arrive.
class RayRow {
 public:
  RayRow(const Scene& scene, const EyeSample& sample, int log2, Workspace& work, FormFactorRow& row)
      : scene_(scene), sample_(sample), pairs_(scene, sample, log2, work), writer_(row, sample.weight) {}

  void add_face(uint16_t index) {
    const Face face = flash_read(scene_.faces, index);
    const bool is_front = height_over(face) > 0;
    Polygon target;
    face_outline(scene_, face, target);
    const int32_t whole = contour_factor(pairs_.eye(), target);
    if (is_front ? whole <= 0 : whole >= 0 || !sample_.back_faces) {
      return;
    }
    pairs_.enter_target(index);
    if (!is_front) {
      back_ = sum_of(back_, arriving(kBackSlot, -whole, target));
      return;
    }
    for (ElementCellWalk walk(scene_, face); walk.next();) {
      const uint16_t element = walk.cells().element;
      element_polygon(scene_, face, walk.cells(), target);
      const int32_t factor =
          pairs_.is_near(element) ? pairs_.source().factor(target) : contour_factor(pairs_.eye(), target);
      sum_ = sum_of(sum_, arriving(element, factor, target));
      writer_.add(element, sum_ >> (kArcBits - kDeltaSumLog2));
    }
  }

  // Part of the hemisphere that back faces take, UQ1.20, as far as the rays tell.
  uint32_t back() const { return back_ >> (kArcBits - kDeltaSumLog2); }

 private:
  int32_t height_over(const Face& face) const {
    const Vec3 corner = vec(flash_read(scene_.vertices, corner_vertex(scene_, face, 0)));
    const Vec3& p = sample_.eye.position;
    return dot(vec(face.normal),
               {p.x - corner.x * kEyeScale, p.y - corner.y * kEyeScale, p.z - corner.z * kEyeScale});
  }

  static uint32_t sum_of(uint32_t a, uint32_t b) {
    return saturate(static_cast<uint64_t>(a) + b, Place::sum_of_pairs, kRaySumLimit);
  }

  // The part of a factor that its rays let through.
  uint32_t arriving(uint16_t slot, int32_t factor, const Polygon& target) {
    return factor <= 0 ? 0
                       : (static_cast<uint32_t>(factor) >> pairs_.log2()) * pairs_.free_rays(slot, target);
  }

  const Scene& scene_;
  const EyeSample& sample_;
  RayPairs pairs_;
  RowWriter writer_;
  uint32_t sum_ = 0, back_ = 0;  // UQ2.30
};

uint32_t sum_of_shares(const FormFactorRow& row) {
  uint32_t sum = 0;
  for (uint16_t j = 0; j < row.count; ++j) {
    sum += row.share[j];
  }
  return sum;
}

}  // namespace

Status ray_row(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
               FormFactorRow& row) {
  uint32_t hidden = 0;
  const Status status = hidden_share(scene, flash_read(kLunes, 2), sample.eye, true, work, hidden);
  if (status != Status::ok) {
    return status;
  }
  if (!sample.back_faces && hidden <= kRayGap) {
    hidden = 0;
  }
  const uint32_t lost = static_cast<uint32_t>(wide_product(sample.weight, hidden) >> kDeltaSumLog2);
  const uint32_t before = sum_of_shares(row);
  const int log2 = table.resolution_log2 < kMaxRaysLog2 ? table.resolution_log2 : kMaxRaysLog2;
  RayRow rays(scene, sample, log2, work, row);
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    if (f != sample.eye.face) {
      rays.add_face(f);
    }
  }
  const uint32_t to_backs = static_cast<uint32_t>(wide_product(sample.weight, rays.back()) >> kDeltaSumLog2);
  const uint32_t back = row.back + (to_backs < lost ? to_backs : lost);
  const uint32_t escaped = row.escaped + row.back + lost - back;
  row.back = row.escaped = 0;
  balance_row(row, before + sample.weight - lost);
  row.back = back;
  row.escaped += escaped;
  return Status::ok;
}

}  // namespace fixrad

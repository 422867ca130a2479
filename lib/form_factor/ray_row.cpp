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

// The rows on which hidden_share() looks; the faces come after them in ViewCursor::next.
constexpr int kHiddenLog2 = 4;
constexpr uint16_t kFirstFace = (1u << kHiddenLog2) + 2;

constexpr int kRayShift = kArcBits - kDeltaSumLog2;

// One eye's row: the factors of the pairs, times the part of their rays that arrive. Sums are the view's.
class RayRow {
 public:
  RayRow(const Scene& scene, const EyeSample& sample, int log2, Workspace& work, FormFactorRow& row)
      : scene_(scene),
        sample_(sample),
        work_(work),
        pairs_(scene, sample, log2, work),
        writer_(row, sample.weight, work.at.sum >> kRayShift) {}

  // False if the budget ends before the face is complete.
  bool add_face(uint16_t index) {
    const Face face = flash_read(scene_.faces, index);
    const bool is_front = height_over(face) > 0;
    Polygon target;
    face_outline(scene_, face, target);
    const int32_t whole = contour_factor(pairs_.eye(), target);
    if (is_front ? whole <= 0 : whole >= 0 || !sample_.back_faces) {
      return true;
    }
    pairs_.enter_target(index);
    if (is_front) {
      return add_elements(face, target);
    }
    work_.at.back = sum_of(work_.at.back, arriving(kBackSlot, -whole, target));
    return true;
  }

 private:
  bool add_elements(const Face& face, Polygon& target) {
    ViewCursor& at = work_.at;
    uint16_t i = 0;
    for (ElementCellWalk walk(scene_, face); walk.next(); ++i) {
      if (i < at.elements) {
        continue;
      }
      if (is_used_up(work_)) {
        return false;
      }
      const uint16_t element = walk.cells().element;
      element_polygon(scene_, face, walk.cells(), target);
      const int32_t factor =
          pairs_.is_near(element) ? pairs_.source().factor(target) : contour_factor(pairs_.eye(), target);
      at.sum = sum_of(at.sum, arriving(element, factor, target));
      writer_.add(element, at.sum >> kRayShift);
      ++at.elements;
      spend(work_);
    }
    at.elements = 0;
    return true;
  }

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
  Workspace& work_;
  RayPairs pairs_;
  RowWriter writer_;
};

uint32_t sum_of_shares(const FormFactorRow& row) {
  uint32_t sum = 0;
  for (uint16_t j = 0; j < row.count; ++j) {
    sum += row.share[j];
  }
  return sum;
}

// What the hemisphere shows no front of, UQ1.20, once the view has found it out.
Status find_hidden(const Scene& scene, const EyeSample& sample, Workspace& work) {
  uint32_t hidden = 0;
  const Status status =
      hidden_share(scene, flash_read(kLunes, kHiddenLog2 - 2), sample.eye, true, work, hidden);
  if (status != Status::ok) {
    return status;
  }
  work.at.next = kFirstFace;
  work.at.hidden = !sample.back_faces && hidden <= kRayGap ? 0 : hidden;
  return Status::ok;
}

// All pairs; in_progress if the budget ends before.
Status add_faces(const Scene& scene, const EyeSample& sample, int log2, Workspace& work, FormFactorRow& row) {
  ViewCursor& at = work.at;
  RayRow rays(scene, sample, log2, work, row);
  for (uint16_t f = static_cast<uint16_t>(at.next - kFirstFace); f < scene.face_count;
       ++f, ++at.next, spend(work)) {
    if (is_used_up(work) || (f != sample.eye.face && !rays.add_face(f))) {
      return Status::in_progress;
    }
  }
  return Status::ok;
}

// What a writer of `weight` has given once it has come to `sum`, UQ1.20.
uint32_t given_part(uint32_t weight, uint32_t sum) {
  return weight == kRowOne
             ? sum
             : static_cast<uint32_t>((wide_product(weight, sum) + kRowOne / 2) >> kDeltaSumLog2);
}

}  // namespace

Status ray_row(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
               FormFactorRow& row) {
  const ViewCursor& at = work.at;
  Status status = at.next < kFirstFace ? find_hidden(scene, sample, work) : Status::ok;
  if (status != Status::ok) {
    return status;
  }
  if (is_used_up(work)) {
    return Status::in_progress;
  }
  const int log2 = table.resolution_log2 < kMaxRaysLog2 ? table.resolution_log2 : kMaxRaysLog2;
  status = add_faces(scene, sample, log2, work, row);
  if (status != Status::ok) {
    return status;
  }
  const uint32_t lost = static_cast<uint32_t>(wide_product(sample.weight, at.hidden) >> kDeltaSumLog2);
  const uint32_t before = sum_of_shares(row) - given_part(sample.weight, at.sum >> kRayShift);
  const uint32_t to_backs =
      static_cast<uint32_t>(wide_product(sample.weight, at.back >> kRayShift) >> kDeltaSumLog2);
  const uint32_t back = row.back + (to_backs < lost ? to_backs : lost);
  const uint32_t escaped = row.escaped + row.back + lost - back;
  row.back = row.escaped = 0;
  balance_row(row, before + sample.weight - lost);
  row.back = back;
  row.escaped += escaped;
  return end_view(work, Status::ok);
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "lib/form_factor/contour.h"
#include "lib/form_factor/engine.h"

namespace fixrad {
namespace {

// What is left uncovered of a closed scene by cuts between elements, at most: 2^-10 of the hemisphere, as
// wide as some slivers of rows. More is a real opening: a closed body seen from outside.
constexpr uint32_t kContourGap = kRowOne >> 10;

// Running sum of the factors, written in the unit of rows and never past one.
class ContourRow {
 public:
  ContourRow(FormFactorRow& row, uint32_t weight) : writer_(row, weight) {}

  void add(uint16_t slot, int32_t factor) {
    if (factor <= 0) {
      return;
    }
    sum_ += static_cast<uint32_t>(factor);
    sum_ = sum_ < static_cast<uint32_t>(kArcOne) ? sum_ : static_cast<uint32_t>(kArcOne);
    writer_.add(slot, sum_ >> (kArcBits - kDeltaSumLog2));
    if (slot < kBackSlot && factor > largest_) {
      largest_ = factor;
      largest_slot_ = slot;
    }
  }

  // The rest of the row; true if it was a gap of a closed scene, which belongs to the largest element.
  bool finish(bool is_closed) {
    const uint32_t rest = kRowOne - (sum_ >> (kArcBits - kDeltaSumLog2));
    const bool is_gap = is_closed && largest_ > 0 && rest <= kContourGap;
    writer_.add(is_gap ? largest_slot_ : kEscapedSlot, kRowOne);
    return is_gap && rest > 0;
  }

 private:
  RowWriter writer_;
  uint32_t sum_ = 0;  // UQ1.30
  int32_t largest_ = 0;
  uint16_t largest_slot_ = kEscapedSlot;
};

int32_t height_over(const Scene& scene, const Face& face, const Vec3& position) {
  const Vec3 corner = vec(flash_read(scene.vertices, corner_vertex(scene, face, 0)));
  return dot(vec(face.normal), {position.x - corner.x * kEyeScale, position.y - corner.y * kEyeScale,
                                position.z - corner.z * kEyeScale});
}

void add_face_elements(const Scene& scene, const Face& face, const ContourPoint& eye, ContourRow& row) {
  Polygon polygon;
  for (ElementCellWalk walk(scene, face); walk.next();) {
    element_polygon(scene, face, walk.cells(), polygon);
    row.add(walk.cells().element, contour_factor(eye, polygon));
  }
}

}  // namespace

Status contour_row(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                   FormFactorRow& row) {
  (void)table;
  const ContourPoint eye =
      contour_point(flash_read(scene.faces, sample.eye.face), fine_point(sample.eye.position));
  ContourRow out(row, sample.weight);
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face face = flash_read(scene.faces, f);
    if (f == sample.eye.face) {
      continue;
    }
    if (height_over(scene, face, sample.eye.position) > 0) {
      add_face_elements(scene, face, eye, out);
    } else if (sample.back_faces) {
      Polygon outline;
      face_outline(scene, face, outline);
      out.add(kBackSlot, -contour_factor(eye, outline));
    }
  }
  work.gaps_closed += out.finish(!sample.back_faces) ? 1u : 0u;
  return Status::ok;
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "lib/form_factor/contour.h"
#include "lib/form_factor/engine.h"

namespace fixrad {
namespace {

// What is left uncovered of a closed scene by cuts between elements, at most: 2^-10 of the hemisphere, as
// wide as some slivers of rows. More is a real opening: a closed body seen from outside.
constexpr uint32_t kContourGap = kRowOne >> 10;

constexpr int kContourShift = kArcBits - kDeltaSumLog2;

// Running sum of the factors, written in the unit of rows and never past one. Sum and largest factor are the
// view's.
class ContourRow {
 public:
  ContourRow(FormFactorRow& row, uint32_t weight, ViewCursor& at)
      : writer_(row, weight, at.sum >> kContourShift), at_(at) {}

  void add(uint16_t slot, int32_t factor) {
    if (factor <= 0) {
      return;
    }
    const uint32_t sum = at_.sum + static_cast<uint32_t>(factor);
    at_.sum = sum < static_cast<uint32_t>(kArcOne) ? sum : static_cast<uint32_t>(kArcOne);
    writer_.add(slot, at_.sum >> kContourShift);
    if (slot < kBackSlot && factor > at_.largest) {
      at_.largest = factor;
      at_.largest_slot = slot;
    }
  }

  // The rest of the row; true if it was a gap of a closed scene, which belongs to the largest element.
  bool finish(bool is_closed) {
    const uint32_t rest = kRowOne - (at_.sum >> kContourShift);
    const bool is_gap = is_closed && at_.largest > 0 && rest <= kContourGap;
    writer_.add(is_gap ? at_.largest_slot : kEscapedSlot, kRowOne);
    return is_gap && rest > 0;
  }

 private:
  RowWriter writer_;
  ViewCursor& at_;
};

int32_t height_over(const Scene& scene, const Face& face, const Vec3& position) {
  const Vec3 corner = vec(flash_read(scene.vertices, corner_vertex(scene, face, 0)));
  return dot(vec(face.normal), {position.x - corner.x * kEyeScale, position.y - corner.y * kEyeScale,
                                position.z - corner.z * kEyeScale});
}

// Adds the elements of a face from the one on that the view has come to; false if the budget ends before.
bool add_face_elements(const Scene& scene, const Face& face, const ContourPoint& eye, Workspace& work,
                       ContourRow& row) {
  Polygon polygon;
  uint16_t i = 0;
  for (ElementCellWalk walk(scene, face); walk.next(); ++i) {
    if (i < work.at.elements) {
      continue;
    }
    if (is_used_up(work)) {
      return false;
    }
    element_polygon(scene, face, walk.cells(), polygon);
    row.add(walk.cells().element, contour_factor(eye, polygon));
    ++work.at.elements;
    spend(work);
  }
  work.at.elements = 0;
  return true;
}

}  // namespace

Status contour_row(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                   FormFactorRow& row) {
  (void)table;
  const ContourPoint eye =
      contour_point(flash_read(scene.faces, sample.eye.face), fine_point(sample.eye.position));
  ViewCursor& at = work.at;
  at.next = at.next == 0 ? 1 : at.next;
  ContourRow out(row, sample.weight, at);
  for (uint16_t f = static_cast<uint16_t>(at.next - 1); f < scene.face_count; ++f, ++at.next, spend(work)) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    const Face face = flash_read(scene.faces, f);
    if (f == sample.eye.face) {
      continue;
    }
    if (height_over(scene, face, sample.eye.position) > 0) {
      if (!add_face_elements(scene, face, eye, work, out)) {
        return Status::in_progress;
      }
    } else if (sample.back_faces) {
      Polygon outline;
      face_outline(scene, face, outline);
      out.add(kBackSlot, -contour_factor(eye, outline));
    }
  }
  work.gaps_closed += out.finish(!sample.back_faces) ? 1u : 0u;
  return end_view(work, Status::ok);
}

}  // namespace fixrad

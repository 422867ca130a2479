// SPDX-License-Identifier: MIT
#include "lib/form_factor/engine.h"
#include "lib/form_factor/spans.h"
#include "lib/form_factor/split.h"

namespace fixrad {
namespace {

bool find_visible(const Scene& scene, const RowPosition& at, Workspace& work, VisibleSpans& visible) {
  visible.reset();
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    if (at.row < view.first_row || at.row > view.last_row) {
      continue;
    }
    const Interval part = face_interval(scene, at, work.directions, view);
    if (part.begin < part.end && !visible.insert(i, part, at)) {
      return false;
    }
  }
  return true;
}

// From inside a closed scene every sample shows a face. Where rounding leaves a sliver uncovered (an eye
// within a thousandth of the room from a wall) it belongs to a neighbour on the row. Wider openings are real:
// a closed body may also be seen from outside.
constexpr int32_t kSliver = kRowEnd / 256;

uint16_t covering_view(const VisibleSpans& visible, uint16_t i, uint16_t previous, bool is_closed,
                       Workspace& work) {
  const uint16_t view = visible[i].view;
  if (view != kNothing || !is_closed || visible.end_of(i) - visible[i].start > kSliver) {
    return view;
  }
  ++work.gaps_closed;
  if (previous != kNothing) {
    return previous;
  }
  const uint16_t next = visible[i].next;
  return next == kNoSpan ? kNothing : visible[next].view;
}

void write_row(const Scene& scene, const RowPosition& at, const DeltaRow& delta, uint32_t base,
               bool is_closed, const VisibleSpans& visible, Workspace& work, RowWriter& writer) {
  uint16_t previous = kNothing;
  for (uint16_t i = visible.first(); i != kNoSpan; i = visible[i].next) {
    const Interval part = {visible[i].start, visible.end_of(i)};
    const uint16_t index = covering_view(visible, i, previous, is_closed, work);
    previous = index;
    if (part.begin >= part.end) {
      continue;
    }
    if (index == kNothing || work.views[index].is_back) {
      writer.add(index == kNothing ? kEscapedSlot : kBackSlot, base + delta.sum_to(part.end));
      continue;
    }
    for (ElementWalk walk(scene, work.views[index], at, part); walk.next();) {
      writer.add(walk.element(), base + delta.sum_to(walk.end()));
    }
  }
}

}  // namespace

Status hemicube_rows(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                     FormFactorRow& row) {
  make_view(scene, sample.eye, sample.back_faces, work);
  VisibleSpans visible(work);
  RowWriter writer(row, sample.begin, sample.weight);
  const int size = 1 << table.resolution_log2;
  uint32_t base = 0;
  for (int side = 0; side < kSides; ++side) {
    enter_side(scene, side, table.resolution_log2, work);
    for (int r = side == kTop ? 0 : size / 2; r < size; ++r) {
      const RowPosition at = row_position(r, table.resolution_log2);
      if (!find_visible(scene, at, work, visible)) {
        return Status::span_pool_full;
      }
      const DeltaRow delta = delta_row(table, side == kTop, r);
      write_row(scene, at, delta, base, !sample.back_faces, visible, work, writer);
      base += 2 * delta.half_total;
    }
  }
  return Status::ok;
}

namespace {

uint32_t hidden_on_row(const VisibleSpans& visible, const DeltaRow& delta, bool nothing_hides,
                       const Workspace& work) {
  uint32_t sum = 0;
  for (uint16_t i = visible.first(); i != kNoSpan; i = visible[i].next) {
    const uint16_t view = visible[i].view;
    if (view == kNothing ? nothing_hides : work.views[view].is_back) {
      sum += delta.sum_to(visible.end_of(i)) - delta.sum_to(visible[i].start);
    }
  }
  return sum;
}

}  // namespace

Status hidden_share(const Scene& scene, const DeltaTable& table, const EyePoint& eye, bool nothing_hides,
                    Workspace& work, uint32_t& share) {
  make_view(scene, eye, true, work);
  VisibleSpans visible(work);
  const int size = 1 << table.resolution_log2;
  enter_side(scene, kTop, table.resolution_log2, work);
  uint32_t hidden = 0;
  uint32_t all = 0;
  for (int r = 0; r < size; ++r) {
    if (!find_visible(scene, row_position(r, table.resolution_log2), work, visible)) {
      return Status::span_pool_full;
    }
    const DeltaRow delta = delta_row(table, true, r);
    hidden += hidden_on_row(visible, delta, nothing_hides, work);
    all += 2 * delta.half_total;
  }
  share = static_cast<uint32_t>(static_cast<uint64_t>(hidden) * kRowOne / all);
  return Status::ok;
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "lib/form_factor/row_sampling.h"

#include "lib/form_factor/split.h"

namespace fixrad {
namespace {

// From inside a closed scene every sample shows a face. Where rounding leaves a sliver uncovered (an eye
// within a thousandth of the room from a wall) it belongs to a neighbour on the row. Wider openings are real:
// a closed body may also be seen from outside.
constexpr int32_t kSliver = kRowEnd / 256;

uint16_t covering_view(const VisibleSpans& visible, uint16_t i, uint16_t previous, bool is_closed,
                       Workspace& work) {
  const uint16_t view = visible.view(i);
  const Interval part = visible.part(i);
  if (view != kNothing || !is_closed || part.end - part.begin > kSliver) {
    return view;
  }
  ++work.gaps_closed;
  if (previous != kNothing) {
    return previous;
  }
  return i + 1u < visible.count() ? visible.view(static_cast<uint16_t>(i + 1)) : kNothing;
}

void write_row(const Scene& scene, const RowPlane& plane, const DeltaRow& delta, uint32_t base,
               bool is_closed, const VisibleSpans& visible, Workspace& work, RowWriter& writer) {
  uint16_t previous = kNothing;
  for (uint16_t i = 0; i < visible.count(); ++i) {
    const Interval part = visible.part(i);
    const uint16_t index = covering_view(visible, i, previous, is_closed, work);
    previous = index;
    if (index == kNothing || work.views[index].is_back) {
      writer.add(index == kNothing ? kEscapedSlot : kBackSlot, base + delta.sum_to(part.end));
      continue;
    }
    for (ElementWalk walk(scene, work.views[index], plane, part); walk.next();) {
      writer.add(walk.element(), base + delta.sum_to(walk.end()));
    }
  }
}

}  // namespace

bool find_visible(const Scene& scene, const BandRow& row, Workspace& work, VisibleSpans& visible) {
  visible.reset();
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    if ((view.rows & row.bit) == 0) {
      continue;
    }
    const Interval part = face_interval(scene, row, work.directions, view);
    if (part.begin < part.end && !visible.insert(i, part, row.plane)) {
      return false;
    }
  }
  return true;
}

bool sample_row(const Scene& scene, const RowSample& sample, Workspace& work, VisibleSpans& visible,
                RowWriter& writer) {
  const BandRow row = band_row(sample.table, sample.first, sample.i);
  if (!find_visible(scene, row, work, visible)) {
    return false;
  }
  const DeltaRow delta = delta_row(sample.table, sample.is_top, sample.first + sample.i);
  write_row(scene, row.plane, delta, work.at.sum, sample.is_closed, visible, work, writer);
  work.at.sum += 2 * delta.half_total;
  return true;
}

SideRow side_row(const DeltaTable& table, int done) {
  const int k = table.resolution_log2;
  const int size = 1 << k, half = size / 2;
  const bool is_top = done < size;
  const int rest = done - size;
  const int side = is_top ? kTop : 1 + (rest >> (k - 1));
  const int in_side = is_top ? done : rest & (half - 1);
  const int begin = is_top ? 0 : half;
  return {side, begin + in_side, begin + (in_side & ~(kBandRows - 1)), in_side == 0};
}

void enter_side_row(const Scene& scene, const DeltaTable& table, const SideRow& at, Workspace& work) {
  if (at.begins_side && at.side != kTop) {
    turn_view(at.side, scene.vertex_count, work);
  }
  if (at.begins_band()) {
    enter_side_band(scene, table, at.side, at.first, band_count(table, at.first), work);
  }
}

}  // namespace fixrad

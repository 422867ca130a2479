// SPDX-License-Identifier: MIT
#include "firmware/float_peer/rows.h"

#include "firmware/float_peer/spans.h"
#include "firmware/float_peer/split.h"

namespace fixrad {
namespace peer {
namespace {

/// Adds the samples of one hemicube row to a row of form factors; they come in order, each ends at a
/// position.
class RowWriter {
 public:
  RowWriter(FormFactorRow& row, const DeltaRow& delta, const EyeSample& sample, float begin)
      : row_(row), delta_(delta), sample_(sample), written_(delta.sum_to(begin)) {}

  /// Everything from the end of the last call up to `x` falls on element `slot`.
  void add(uint16_t slot, float x) { row_.share[slot] += take(x); }
  void add_escaped(float x) { row_.escaped += take(x); }
  void add_back(float x) { row_.back += take(x); }

 private:
  float take(float x) {
    const float sum = delta_.sum_to(x);
    const float part = sum - written_;
    written_ = sum;
    return sample_.is_whole ? part : part * sample_.weight;
  }

  FormFactorRow& row_;
  DeltaRow delta_;
  const EyeSample& sample_;
  float written_;
};

bool find_visible(const Scene& scene, uint8_t row, float size, Workspace& work, VisibleSpans& visible) {
  visible.reset();
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    if (row < view.begin_row || row >= view.end_row) {
      continue;
    }
    const Interval part = face_interval(scene, row, size, work.vertices, view);
    if (part.begin < part.end && !visible.insert(i, part)) {
      return false;
    }
  }
  return true;
}

// As in the core: in a closed scene an uncovered sliver of at most 1/256 of the row belongs to a neighbour.
uint16_t covering_view(const VisibleSpans& visible, uint16_t i, uint16_t previous, bool is_closed,
                       float sliver) {
  const uint16_t view = visible[i].view;
  if (view != kNothing || !is_closed || visible.end_of(i) - visible[i].start > sliver) {
    return view;
  }
  if (previous != kNothing) {
    return previous;
  }
  const uint16_t next = visible[i].next;
  return next == kNoSpan ? kNothing : visible[next].view;
}

void write_row(const Scene& scene, bool is_closed, float sliver, const VisibleSpans& visible,
               const Workspace& work, RowWriter& writer) {
  uint16_t previous = kNothing;
  for (uint16_t i = visible.first(); i != kNoSpan; i = visible[i].next) {
    const Interval part = {visible[i].start, visible.end_of(i)};
    const uint16_t index = covering_view(visible, i, previous, is_closed, sliver);
    previous = index;
    if (index == kNothing) {
      writer.add_escaped(part.end);
    } else if (work.views[index].is_back) {
      writer.add_back(part.end);
    } else {
      for (ElementWalk walk(scene, work.views[index], part); walk.next();) {
        writer.add(walk.element(), walk.end());
      }
    }
  }
}

float hidden_on_row(const VisibleSpans& visible, const DeltaRow& delta, bool nothing_hides,
                    const Workspace& work) {
  float sum = 0.0f;
  for (uint16_t i = visible.first(); i != kNoSpan; i = visible[i].next) {
    const uint16_t view = visible[i].view;
    if (view == kNothing ? nothing_hides : work.views[view].is_back) {
      sum += delta.sum_to(visible.end_of(i)) - delta.sum_to(visible[i].start);
    }
  }
  return sum;
}

}  // namespace

void clear(FormFactorRow& row) {
  for (uint16_t j = 0; j < row.count; ++j) {
    row.share[j] = 0.0f;
  }
  row.escaped = 0.0f;
  row.back = 0.0f;
}

Status hemicube_rows(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                     FormFactorRow& row) {
  make_view(scene, sample.eye, sample.back_faces, true, work);
  const uint8_t half = table.half;
  const float size = static_cast<float>(half);
  VisibleSpans visible(work, size);
  for (uint8_t side = 0; side < kSides; ++side) {
    enter_side(scene, side, half, work);
    for (uint8_t r = first_row(side, half); r < 2 * half; ++r) {
      if (!find_visible(scene, r, size, work, visible)) {
        return Status::span_pool_full;
      }
      RowWriter writer(row, delta_row(table, side == kTop, r), sample, -size);
      write_row(scene, !sample.back_faces, size * (1.0f / 128), visible, work, writer);
    }
  }
  return Status::ok;
}

Status hidden_share(const Scene& scene, const DeltaTable& table, const EyePoint& eye, bool nothing_hides,
                    Workspace& work, float& share) {
  make_view(scene, eye, true, false, work);
  const uint8_t half = table.half;
  const float size = static_cast<float>(half);
  VisibleSpans visible(work, size);
  enter_side(scene, kTop, half, work);
  float hidden = 0.0f;
  float all = 0.0f;
  for (uint8_t r = 0; r < 2 * half; ++r) {
    if (!find_visible(scene, r, size, work, visible)) {
      return Status::span_pool_full;
    }
    const DeltaRow delta = delta_row(table, true, r);
    hidden += hidden_on_row(visible, delta, nothing_hides, work);
    all += 2.0f * delta.sum_to(size);
  }
  share = hidden / all;
  return Status::ok;
}

}  // namespace peer
}  // namespace fixrad

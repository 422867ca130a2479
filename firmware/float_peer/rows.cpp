// SPDX-License-Identifier: MIT
#include "firmware/float_peer/rows.h"

#include "firmware/float_peer/spans.h"
#include "firmware/float_peer/split.h"

namespace fixrad {
namespace peer {
namespace {

/// Adds the samples of one lune to a row of form factors; they come in order, each ends at a
/// position.
class RowWriter {
 public:
  RowWriter(FormFactorRow& row, const LuneRow& lune) : row_(row), lune_(lune) {}

  /// Everything from the end of the last call up to `x` falls on element `slot`.
  void add(uint16_t slot, float x) { row_.share[slot] += take(x); }
  void add_escaped(float x) { row_.escaped += take(x); }
  void add_back(float x) { row_.back += take(x); }

 private:
  float take(float x) {
    const float sum = lune_.sum_to(x);
    const float part = sum - written_;
    written_ = sum;
    return part;
  }

  FormFactorRow& row_;
  LuneRow lune_;
  float written_ = -0.5f;
};

bool find_visible(const Scene& scene, uint8_t row, float y, Workspace& work, VisibleSpans& visible) {
  visible.reset();
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    if (row < view.begin_row || row >= view.end_row) {
      continue;
    }
    const Interval part = face_interval(scene, row, y, work.vertices, view);
    if (part.begin < part.end) {
      view.row_depth = on_row(view.depth, y);
      if (!visible.insert(i, part)) {
        return false;
      }
    }
  }
  return true;
}

// As in the core: in a closed scene an uncovered sliver of a row belongs to a neighbour.
uint16_t covering_view(const LuneRow& lune, const VisibleSpans& visible, uint16_t i, uint16_t previous,
                       bool is_closed) {
  constexpr float kSliver = 1.0f / 256;
  const uint16_t view = visible[i].view;
  if (view != kNothing || !is_closed ||
      lune.sum_to(visible.end_of(i)) - lune.sum_to(visible[i].start) > kSliver) {
    return view;
  }
  if (previous != kNothing) {
    return previous;
  }
  const uint16_t next = visible[i].next;
  return next == kNoSpan ? kNothing : visible[next].view;
}

void write_row(const Scene& scene, bool is_closed, const LuneRow& lune, const VisibleSpans& visible,
               const Workspace& work, RowWriter& writer) {
  uint16_t previous = kNothing;
  for (uint16_t i = visible.first(); i != kNoSpan; i = visible[i].next) {
    const Interval part = {visible[i].start, visible.end_of(i)};
    const uint16_t index = covering_view(lune, visible, i, previous, is_closed);
    previous = index;
    if (index == kNothing) {
      writer.add_escaped(part.end);
    } else if (work.views[index].is_back) {
      writer.add_back(part.end);
    } else {
      for (ElementWalk walk(scene, work.views[index], lune.y, part); walk.next();) {
        writer.add(walk.element(), walk.end());
      }
    }
  }
}

float hidden_on_row(const VisibleSpans& visible, const LuneRow& lune, bool nothing_hides,
                    const Workspace& work) {
  float sum = 0.0f;
  for (uint16_t i = visible.first(); i != kNoSpan; i = visible[i].next) {
    const uint16_t view = visible[i].view;
    if (view == kNothing ? nothing_hides : work.views[view].is_back) {
      sum += lune.sum_to(visible.end_of(i)) - lune.sum_to(visible[i].start);
    }
  }
  return sum;
}

}  // namespace

void clear(FormFactorRow& row) {
  for (uint16_t j = 0; j < row.count; ++j) {
    row.share[j] = 0.0f;
  }
  row.whole = 0.0f;
  row.escaped = 0.0f;
  row.back = 0.0f;
}

Status lune_rows(const Scene& scene, const LuneTable& table, const EyePoint& eye, Backs backs,
                 Workspace& work, FormFactorRow& row) {
  make_view(scene, eye, backs, true, work);
  enter_rows(scene, table, work);
  VisibleSpans visible(work);
  for (uint8_t r = 0; r < table.size; ++r) {
    const LuneRow lune = lune_row(table, r);
    if (!find_visible(scene, r, lune.y, work, visible)) {
      return Status::span_pool_full;
    }
    RowWriter writer(row, lune);
    write_row(scene, backs == Backs::none, lune, visible, work, writer);
  }
  row.whole += static_cast<float>(table.size);
  return Status::ok;
}

Status hidden_share(const Scene& scene, const LuneTable& table, const EyePoint& eye, bool nothing_hides,
                    Workspace& work, float& share) {
  make_view(scene, eye, Backs::all, false, work);
  enter_rows(scene, table, work);
  VisibleSpans visible(work);
  float hidden = 0.0f;
  for (uint8_t r = 0; r < table.size; ++r) {
    const LuneRow lune = lune_row(table, r);
    if (!find_visible(scene, r, lune.y, work, visible)) {
      return Status::span_pool_full;
    }
    hidden += hidden_on_row(visible, lune, nothing_hides, work);
  }
  share = hidden / static_cast<float>(table.size);
  return Status::ok;
}

}  // namespace peer
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "lib/form_factor/spans.h"

#include "lib/fixed/checked.h"

#include "lib/form_factor/delta_table.h"

namespace fixrad {
namespace {

// A face's depth (14 bits) times a direction (at most sqrt(3) 2^11) is below 2^26; with four bits more the
// difference of two still is below 2^31.
constexpr int kGuardBits = 4;

// Shifts beyond the width of a number leave its sign.
int capped(int shift) {
  return shift < 31 ? shift : 31;
}

// The position where two faces are equally near; both lines come to the exponent of the farther face.
int32_t where_equal(const RowDepth& a, const RowDepth& b, Interval part, bool rises) {
  const int difference = a.shift - b.shift;
  const int32_t ax = difference > 0 ? floor_shift(a.x, capped(difference)) : a.x;
  const int32_t am = difference > 0 ? floor_shift(a.m, capped(difference)) : a.m;
  const int32_t bx = difference < 0 ? floor_shift(b.x, capped(-difference)) : b.x;
  const int32_t bm = difference < 0 ? floor_shift(b.m, capped(-difference)) : b.m;
  return crossing_within(part, rises, ax - bx, am - bm, a.fold);
}

}  // namespace

RowDepth row_depth(const FaceView& view, const RowPlane& plane) {
  const int32_t m = view.depth[1] * plane.y + view.depth[2] * plane.z;
  return {static_cast<int32_t>(view.depth[0]) * (1 << kGuardBits), floor_shift(m, kPlaneBits - kGuardBits),
          plane.fold, view.depth_shift};
}

int32_t nearness(const RowDepth& a, const RowDepth& b, int32_t position) {
  const int difference = a.shift - b.shift;
  const int32_t at_a = a.at(position), at_b = b.at(position);
  return difference > 0 ? floor_shift(at_a, capped(difference)) - at_b
                        : at_a - floor_shift(at_b, capped(-difference));
}

namespace {

// The piece of `part` where `a` is nearer than `b`.
Interval nearer_part(const RowDepth& a, const RowDepth& b, Interval part) {
  const int32_t begin = nearness(a, b, part.begin);
  const int32_t end = nearness(a, b, part.end);
  if (begin <= 0 && end <= 0) {
    return {part.begin, part.begin};
  }
  if (begin >= 0 && end >= 0) {
    return part;
  }
  const int32_t border = where_equal(a, b, part, begin < 0);
  return begin > 0 ? Interval{part.begin, border} : Interval{border, part.end};
}

}  // namespace

void VisibleSpans::reset() {
  work_.spans[0] = {0, kNothing};
  work_.spans[1] = {static_cast<int16_t>(kRowEnd), kNothing};
  count_ = 1;
}

// Makes room for `spans` spans before span i.
bool VisibleSpans::open(uint16_t i, uint16_t spans) {
  const uint16_t used = static_cast<uint16_t>(count_ + 1 + spans);
  if (used > work_.span_capacity) {
    return false;
  }
  for (uint16_t k = count_ + 1; k-- > i;) {
    work_.spans[k + spans] = work_.spans[k];
  }
  count_ = static_cast<uint16_t>(count_ + spans);
  work_.span_high_water = used > work_.span_high_water ? used : work_.span_high_water;
  return true;
}

// Takes span i out; the one before it grows.
void VisibleSpans::close(uint16_t i) {
  for (uint16_t k = i; k < count_; ++k) {
    work_.spans[k] = work_.spans[k + 1];
  }
  --count_;
}

// Gives `part` of span i to `index` and moves i to the last of the spans that come of it. Joins it to the
// span before where that shows the same face, so that a face that replaces many keeps one span.
bool VisibleSpans::paint(uint16_t& i, Interval part, uint16_t index) {
  Span* spans = work_.spans;
  const bool has_head = part.begin > spans[i].start;
  const bool has_tail = part.end < spans[i + 1].start;
  if (!has_head && i > 0 && spans[i - 1].view == index) {
    if (has_tail) {
      spans[i].start = narrow<int16_t>(part.end, Place::row_position);
    } else {
      close(i--);
    }
    return true;
  }
  const uint16_t old = spans[i].view;
  if (has_head || has_tail) {
    if (!open(static_cast<uint16_t>(i + 1), has_head && has_tail ? 2 : 1)) {
      return false;
    }
  }
  if (has_head) {
    spans[++i].start = narrow<int16_t>(part.begin, Place::row_position);
  }
  spans[i].view = index;
  if (has_tail) {
    spans[++i] = {narrow<int16_t>(part.end, Place::row_position), old};
  }
  return true;
}

// The piece of `part` on which view `a` is nearer than `b`. The first two faces of a view that meet have the
// depths of all its faces made.
Interval VisibleSpans::won_part(uint16_t a, uint16_t b, Interval part, const RowPlane& plane) {
  if (work_.views[a].depth_shift == 0) {
    make_depths(scene_, eye_, work_);
  }
  return nearer_part(row_depth(work_.views[a], plane), row_depth(work_.views[b], plane), part);
}

bool VisibleSpans::insert(uint16_t index, Interval part, const RowPlane& plane) {
  const Span* spans = work_.spans;
  uint16_t i = 0;
  while (spans[i + 1].start <= part.begin) {
    ++i;
  }
  if (spans[i].view == kNothing && part.end <= spans[i + 1].start) {
    return paint(i, part, index);
  }
  for (; spans[i].start < part.end; ++i) {
    Interval won = {spans[i].start > part.begin ? spans[i].start : part.begin,
                    spans[i + 1].start < part.end ? spans[i + 1].start : part.end};
    if (spans[i].view != kNothing) {
      won = won_part(index, spans[i].view, won, plane);
    }
    if (won.begin < won.end && !paint(i, won, index)) {
      return false;
    }
  }
  return true;
}

}  // namespace fixrad

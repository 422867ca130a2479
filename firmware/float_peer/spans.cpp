// SPDX-License-Identifier: MIT
#include "firmware/float_peer/spans.h"

namespace fixrad {
namespace peer {

void VisibleSpans::reset() {
  work_.spans[0] = {-kRowEnd, kNothing, kNoSpan};
  free_ = kNoSpan;
  used_ = 1;
}

// The difference of two values of 1/depth is linear along the row; a sign costs less than a comparison.
VisibleSpans::Contest VisibleSpans::contest(uint16_t index, uint16_t other, Interval part) const {
  if (other == kNothing) {
    return {Win::all, 0.0f};
  }
  const RowFunction& a = work_.views[index].row_depth;
  const RowFunction& b = work_.views[other].row_depth;
  const float slope = b.slope - a.slope;
  const float middle = b.at_row - a.at_row;
  const bool near_at_begin = __builtin_signbit(slope * part.begin + middle);
  const bool near_at_end = __builtin_signbit(slope * part.end + middle);
  if (near_at_begin == near_at_end) {
    return {near_at_begin ? Win::all : Win::nothing, 0.0f};
  }
  const float zero = -middle / slope;
  if (!(zero > part.begin)) {
    return {near_at_begin ? Win::nothing : Win::all, 0.0f};
  }
  if (!(zero < part.end)) {
    return {near_at_begin ? Win::all : Win::nothing, 0.0f};
  }
  return {near_at_begin ? Win::begin : Win::end, zero};
}

// Cuts span i at x (inside it) and returns the right-hand half, or kNoSpan if the pool is full.
uint16_t VisibleSpans::cut(uint16_t i, float x) {
  uint16_t fresh = free_;
  if (fresh != kNoSpan) {
    free_ = work_.spans[fresh].next;
  } else if (used_ < work_.span_capacity) {
    fresh = used_++;
  } else {
    return kNoSpan;
  }
  work_.spans[fresh] = {x, work_.spans[i].view, work_.spans[i].next};
  work_.spans[i].next = fresh;
  return fresh;
}

// Gives `part` of span i to `index`; `cut_begin`, `cut_end`: the span reaches beyond it on that side. Joins
// it to `previous` where that shows the same face. `i` becomes a span from which the rest of the list can be
// reached.
bool VisibleSpans::paint(uint16_t previous, uint16_t& i, uint16_t index, Interval part, bool cut_begin,
                         bool cut_end) {
  if (cut_end && cut(i, part.end) == kNoSpan) {
    return false;
  }
  if (cut_begin) {
    i = cut(i, part.begin);
    if (i == kNoSpan) {
      return false;
    }
  } else if (previous != kNoSpan && work_.spans[previous].view == index) {
    work_.spans[previous].next = work_.spans[i].next;
    work_.spans[i].next = free_;
    free_ = i;
    i = previous;
    return true;
  }
  work_.spans[i].view = index;
  return true;
}

bool VisibleSpans::insert(uint16_t index, Interval part) {
  uint16_t previous = kNoSpan;
  uint16_t i = 0;
  uint16_t next = work_.spans[0].next;
  while (next != kNoSpan && work_.spans[next].start <= part.begin) {
    previous = i;
    i = next;
    next = work_.spans[i].next;
  }
  float begin = part.begin;
  bool cut_begin = work_.spans[i].start < begin;
  for (;;) {
    const float span_end = next == kNoSpan ? kRowEnd : work_.spans[next].start;
    const bool cut_end = part.end < span_end;
    const float end = cut_end ? part.end : span_end;
    const Contest won = contest(index, work_.spans[i].view, {begin, end});
    const bool loses_begin = won.win == Win::end, loses_end = won.win == Win::begin;
    if (won.win != Win::nothing &&
        !paint(previous, i, index, {loses_begin ? won.border : begin, loses_end ? won.border : end},
               cut_begin || loses_begin, cut_end || loses_end)) {
      return false;
    }
    if (cut_end || next == kNoSpan || part.end <= span_end) {
      return true;
    }
    while (work_.spans[i].next != next) {
      i = work_.spans[i].next;
    }
    previous = i;
    i = next;
    next = work_.spans[i].next;
    begin = span_end;
    cut_begin = false;
  }
}

}  // namespace peer
}  // namespace fixrad

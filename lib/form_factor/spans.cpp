// SPDX-License-Identifier: MIT
#include "lib/form_factor/spans.h"

#include "lib/form_factor/delta_table.h"

namespace fixrad {
namespace {

Vec3 depth_normal(const FaceView& view) {
  return vec(view.depth_normal);
}

// begin + (end - begin) * a / (a + b), with a and b cut to the 19 bits that the dividend has room for.
int32_t zero_between(Interval part, uint64_t a, uint64_t b) {
  while ((a | b) >> 19 != 0) {
    a >>= 1;
    b >>= 1;
  }
  const uint32_t width = static_cast<uint32_t>(part.end - part.begin);
  const uint32_t sum = static_cast<uint32_t>(a + b);
  return part.begin + (sum == 0 ? 0 : static_cast<int32_t>(width * static_cast<uint32_t>(a) / sum));
}

}  // namespace

int64_t nearness(const FaceView& a, const FaceView& b, Vec3 d) {
  return static_cast<int64_t>(dot(depth_normal(a), d)) * b.depth_distance -
         static_cast<int64_t>(dot(depth_normal(b), d)) * a.depth_distance;
}

void VisibleSpans::reset() {
  work_.spans[0] = {0, kNothing, kNoSpan};
  free_ = kNoSpan;
  used_ = 1;
}

int32_t VisibleSpans::end_of(uint16_t i) const {
  const uint16_t next = work_.spans[i].next;
  return next == kNoSpan ? kRowEnd : work_.spans[next].start;
}

Interval VisibleSpans::nearer_part(uint16_t index, uint16_t other, Interval part,
                                   const RowPosition& at) const {
  if (other == kNothing) {
    return part;
  }
  const FaceView& a = work_.views[index];
  const FaceView& b = work_.views[other];
  const int64_t begin = nearness(a, b, at.direction(part.begin));
  const int64_t end = nearness(a, b, at.direction(part.end));
  if (begin <= 0 && end <= 0) {
    return {part.begin, part.begin};
  }
  if (begin >= 0 && end >= 0) {
    return part;
  }
  if (begin > 0) {
    return {part.begin, zero_between(part, static_cast<uint64_t>(begin), static_cast<uint64_t>(-end))};
  }
  return {zero_between(part, static_cast<uint64_t>(-begin), static_cast<uint64_t>(end)), part.end};
}

// Cuts span i at x (inside it) and returns the right-hand half, or kNoSpan if the pool is full.
uint16_t VisibleSpans::split(uint16_t i, int32_t x) {
  uint16_t fresh = free_;
  if (fresh != kNoSpan) {
    free_ = work_.spans[fresh].next;
  } else if (used_ < work_.span_capacity) {
    fresh = used_++;
    work_.span_high_water = used_ > work_.span_high_water ? used_ : work_.span_high_water;
  } else {
    return kNoSpan;
  }
  work_.spans[fresh] = {static_cast<uint16_t>(x), work_.spans[i].view, work_.spans[i].next};
  work_.spans[i].next = fresh;
  return fresh;
}

// Gives `part` of span i to `index`; joins it to `previous` where that shows the same face, so that a face
// that replaces many keeps one span.
bool VisibleSpans::paint(uint16_t& previous, uint16_t i, Interval part, uint16_t index) {
  if (part.end < end_of(i) && split(i, part.end) == kNoSpan) {
    return false;
  }
  if (part.begin > work_.spans[i].start) {
    previous = i;
    i = split(i, part.begin);
    if (i == kNoSpan) {
      return false;
    }
  }
  work_.spans[i].view = index;
  if (previous != kNoSpan && work_.spans[previous].view == index) {
    work_.spans[previous].next = work_.spans[i].next;
    work_.spans[i].next = free_;
    free_ = i;
  } else {
    previous = i;
  }
  return true;
}

bool VisibleSpans::insert(uint16_t index, Interval part, const RowPosition& at) {
  uint16_t previous = kNoSpan;
  uint16_t i = 0;
  while (i != kNoSpan && work_.spans[i].start < part.end) {
    const int32_t start = work_.spans[i].start;
    const int32_t end = end_of(i);
    if (end > part.begin) {
      const Interval overlap = {start > part.begin ? start : part.begin, end < part.end ? end : part.end};
      const Interval won = nearer_part(index, work_.spans[i].view, overlap, at);
      if (won.begin < won.end) {
        if (!paint(previous, i, won, index)) {
          return false;
        }
        i = work_.spans[previous].next;
      }
    }
    while (i != kNoSpan && work_.spans[i].start < end) {
      previous = i;
      i = work_.spans[i].next;
    }
  }
  return true;
}

}  // namespace fixrad

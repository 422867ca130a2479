// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_spans.h"

#include <algorithm>

namespace fixrad::host {
namespace {

// The part on which `a` is nearer than `b`: the difference of inverse depths is one plane through the eye,
// and a row meets it once at most.
TwinInterval nearer_part(const TwinFaceView& a, const TwinFaceView& b, TwinInterval part,
                         const TwinRow& row) {
  const glm::dvec3 difference = a.plane - b.plane;
  const double begin = glm::dot(difference, row.direction(part.begin));
  const double end = glm::dot(difference, row.direction(part.end));
  if (begin <= 0 && end <= 0) {
    return {part.begin, part.begin};
  }
  if (begin >= 0 && end >= 0) {
    return part;
  }
  const double zero = std::clamp(row.crossing(difference), part.begin, part.end);
  return begin > 0 ? TwinInterval{part.begin, zero} : TwinInterval{zero, part.end};
}

}  // namespace

// Cuts span i at x (inside it) and returns the right-hand half.
std::uint32_t TwinSpans::split(std::uint32_t i, double x) {
  std::uint32_t fresh = free_;
  if (fresh != kTwinNothing) {
    free_ = spans_[fresh].next;
  } else {
    fresh = static_cast<std::uint32_t>(spans_.size());
    spans_.push_back({});
  }
  spans_[fresh] = {x, spans_[i].view, spans_[i].next};
  spans_[i].next = fresh;
  return fresh;
}

// Gives `part` of span i to `index`; joins it to `previous` where that shows the same face. Returns the span
// that now ends at part.end.
std::uint32_t TwinSpans::paint(std::uint32_t previous, std::uint32_t i, TwinInterval part,
                               std::uint32_t index) {
  if (part.end < end_of(i)) {
    split(i, part.end);
  }
  if (part.begin > spans_[i].start) {
    previous = i;
    i = split(i, part.begin);
  }
  spans_[i].view = index;
  if (previous == kTwinNothing || spans_[previous].view != index) {
    return i;
  }
  spans_[previous].next = spans_[i].next;
  spans_[i].next = free_;
  free_ = i;
  return previous;
}

void TwinSpans::insert(std::uint32_t index, TwinInterval part, const TwinRow& row, const TwinView& view) {
  std::uint32_t previous = kTwinNothing;
  std::uint32_t i = 0;
  while (i != kTwinNothing && spans_[i].start < part.end) {
    const double end = end_of(i);
    if (end > part.begin) {
      const TwinInterval overlap = {std::max(spans_[i].start, part.begin), std::min(end, part.end)};
      const std::uint32_t other = spans_[i].view;
      const TwinInterval won =
          other == kTwinNothing ? overlap : nearer_part(view.faces[index], view.faces[other], overlap, row);
      if (won.begin < won.end) {
        previous = paint(previous, i, won, index);
        i = spans_[previous].next;
      }
    }
    while (i != kTwinNothing && spans_[i].start < end) {
      previous = i;
      i = spans_[i].next;
    }
  }
}

}  // namespace fixrad::host

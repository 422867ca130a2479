// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/reference/twin_scanline.h"

namespace fixrad::host {

constexpr std::uint32_t kTwinNothing = 0xffffffff;

/// What is visible along one row, resolved between faces, as VisibleSpans of the core does it: a linked list
/// of spans from -1 to 1, each showing one face or nothing. The pool grows to what the widest row needs and
/// is then reused.
class TwinSpans {
 public:
  struct Span {
    double start;
    std::uint32_t view;  ///< index into TwinView::faces, or kTwinNothing
    std::uint32_t next;  ///< index into the pool, or kTwinNothing
  };

  explicit TwinSpans(std::size_t faces) { spans_.reserve(2 * faces + 1); }

  /// Starts a row that shows nothing.
  void reset() {
    spans_.assign(1, {-1.0, kTwinNothing, kTwinNothing});
    free_ = kTwinNothing;
  }

  /// Shows view `index` on `part` where it is nearer than what is there; of equals the earlier one stays.
  /// Faces that pierce each other are split where they cross.
  void insert(std::uint32_t index, TwinInterval part, const TwinRow& row, const TwinView& view);

  const Span& operator[](std::uint32_t i) const { return spans_[i]; }
  double end_of(std::uint32_t i) const {
    const std::uint32_t next = spans_[i].next;
    return next == kTwinNothing ? 1.0 : spans_[next].start;
  }

 private:
  std::uint32_t split(std::uint32_t i, double x);
  std::uint32_t paint(std::uint32_t previous, std::uint32_t i, TwinInterval part, std::uint32_t index);

  std::vector<Span> spans_;
  std::uint32_t free_ = kTwinNothing;
};

}  // namespace fixrad::host

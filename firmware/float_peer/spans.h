// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/scanline.h"

namespace fixrad {
namespace peer {

/// What is visible along one row, resolved between faces: a linked list of spans, each showing one face or
/// nothing, kept in a bounded pool. As in the core.
class VisibleSpans {
 public:
  explicit VisibleSpans(Workspace& work) : work_(work) {}

  /// Starts a row that shows nothing.
  void reset();

  /// Shows view `index` on `part` (not empty) where it is nearer than what is there; of equals the earlier
  /// one stays. Faces that pierce each other are split where they cross. False if the pool is full: the row
  /// is then unusable. Cost: a comparison a span, two products and a few sums an overlap with another face.
  bool insert(uint16_t index, Interval part);

  uint16_t first() const { return 0; }
  const Span& operator[](uint16_t i) const { return work_.spans[i]; }
  float end_of(uint16_t i) const {
    const uint16_t next = work_.spans[i].next;
    return next == kNoSpan ? kRowEnd : work_.spans[next].start;
  }

 private:
  // What a face wins of an interval that another one holds.
  enum class Win : uint8_t { nothing, all, begin, end };
  struct Contest {
    Win win;
    float border;  // where it ends or begins, if it wins only the begin or the end
  };

  Contest contest(uint16_t index, uint16_t other, Interval part) const;
  uint16_t cut(uint16_t i, float x);
  bool paint(uint16_t previous, uint16_t& i, uint16_t index, Interval part, bool cut_begin, bool cut_end);

  Workspace& work_;
  uint16_t free_ = kNoSpan;
  uint16_t used_ = 0;
};

}  // namespace peer
}  // namespace fixrad

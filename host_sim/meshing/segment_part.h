// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace fixrad::host {

/// The part of a segment, from its start (0) to its end (1), on which some linear functions are not negative:
/// what half-planes and half-spaces leave of it.
struct SegmentPart {
  double begin = 0;
  double end = 1;

  /// Gives up the part on which a linear function is below 0; its values at the segment's ends.
  void keep_where(double at_start, double at_end) {
    if (at_start < 0 && at_end < 0) {
      end = -1;
    } else if (at_start < 0) {
      begin = std::max(begin, at_start / (at_start - at_end));
    } else if (at_end < 0) {
      end = std::min(end, at_start / (at_start - at_end));
    }
  }

  /// 0 where nothing is left.
  double length() const { return std::max(0.0, end - begin); }
};

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "lib/picture/coverage.h"

namespace fixrad {
namespace {

// More columns than a picture's guard is wide, so that what is divided is not negative.
constexpr int32_t kColumnOffset = 1l << 14;

void order(ScreenCorner& upper, ScreenCorner& lower) {
  if (lower.y < upper.y) {
    const ScreenCorner moved = upper;
    upper = lower;
    lower = moved;
  }
}

}  // namespace

// Column = ceil((x - 128) / 256) with x = top.x + (centre - top.y) dx / dy, over the common divisor 256 dy.
EdgeWalk::EdgeWalk(const ScreenCorner& top, const ScreenCorner& bottom, int32_t row) {
  const int32_t dx = bottom.x - top.x, dy = bottom.y - top.y;
  constexpr int32_t kPixel = 1l << kPixelBits, half = kPixel / 2;
  const int32_t down = row * kPixel + half - top.y;
  divisor_ = static_cast<uint32_t>(dy) << kPixelBits;
  const int64_t numerator = static_cast<int64_t>(top.x - half) * dy + static_cast<int64_t>(down) * dx;
  const int64_t lifted = numerator + static_cast<int64_t>(divisor_) * kColumnOffset + (divisor_ - 1);
  const uint64_t quotient = static_cast<uint64_t>(lifted) / divisor_;
  rest_ = static_cast<uint32_t>(static_cast<uint64_t>(lifted) - quotient * divisor_);
  column_ = static_cast<int32_t>(quotient) - kColumnOffset;
  step_ = dx / dy;
  if (dx - step_ * dy < 0) {
    --step_;
  }
  rest_step_ = static_cast<uint32_t>(dx - step_ * dy) << kPixelBits;
}

void EdgeWalk::next_row() {
  column_ += step_;
  rest_ += rest_step_;
  if (rest_ >= divisor_) {
    rest_ -= divisor_;
    ++column_;
  }
}

Coverage::Coverage(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c) : corner_{a, b, c} {
  order(corner_[0], corner_[1]);
  order(corner_[1], corner_[2]);
  order(corner_[0], corner_[1]);
  is_bend_right_ = screen_area(corner_[0], corner_[1], corner_[2]) > 0;
}

int64_t screen_area(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c) {
  return static_cast<int64_t>(b.x - a.x) * (c.y - a.y) - static_cast<int64_t>(b.y - a.y) * (c.x - a.x);
}

}  // namespace fixrad

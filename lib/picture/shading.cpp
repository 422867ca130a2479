// SPDX-License-Identifier: MIT
#include "lib/picture/shading.h"

namespace fixrad {
namespace {

constexpr int kAreaBits = 31;
constexpr int kWeightBits = 28;

int wide_bit_length(uint64_t a) {
  const uint32_t high = static_cast<uint32_t>(a >> 32);
  return high != 0 ? 32 + bit_length(high) : bit_length(static_cast<uint32_t>(a));
}

// a / 2^shift, or times 2^-shift.
int64_t shifted(int64_t a, int shift) {
  return shift >= 0 ? a >> shift : a * (static_cast<int64_t>(1) << -shift);
}

uint32_t shifted(uint32_t a, int shift) {
  return shift >= 0 ? a >> shift : a << -shift;
}

uint32_t larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

}  // namespace

TriangleShading::TriangleShading(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c,
                                 int64_t area) {
  const int area_length = wide_bit_length(static_cast<uint64_t>(area));
  area_shift_ = area_length > kAreaBits ? area_length - kAreaBits : 0;
  const uint32_t short_area = static_cast<uint32_t>(area >> area_shift_);
  const uint32_t nearest = larger(larger(a.inverse, b.inverse), c.inverse);
  weight_shift_ = bit_length(short_area) + bit_length(nearest) - kWeightBits;
  reference_x_ = floor_shift(a.x, kPixelBits);
  reference_y_ = floor_shift(a.y, kPixelBits);
  set(weight_[0], b, c, a.inverse);
  set(weight_[1], c, a, b.inverse);
  set(weight_[2], a, b, c.inverse);
  const int top_shift = bit_length(short_area) - 16;
  area_ = shifted(short_area, top_shift);
  // distance = area 2^37 / (sum of weights), in 1/16 unit; 2^31 of it are in the reciprocal, 6 in the depth.
  depth_shift_ = weight_shift_ - top_shift - (kInverseBits - 31) + kViewBits + kDepthBits;
}

// The edge function of from -> to, at the reference's centre and its steps, times 1/distance.
void TriangleShading::set(Weight& weight, const ScreenCorner& from, const ScreenCorner& to,
                          uint32_t inverse) {
  const int64_t half = 1l << (kPixelBits - 1), whole = 1l << kPixelBits;
  const int64_t dx = to.x - from.x, dy = to.y - from.y;
  const int64_t px = reference_x_ * whole + half - from.x, py = reference_y_ * whole + half - from.y;
  const auto scaled = [&](int64_t edge) {
    return static_cast<uint32_t>(shifted((edge >> area_shift_) * inverse, weight_shift_));
  };
  weight.at_reference = scaled(dx * py - dy * px);
  weight.by_column = scaled(-dy * whole);
  weight.by_row = scaled(dx * whole);
  weight.value = weight.at_reference;
}

FIXRAD_MODULO void TriangleShading::start(int32_t x, int32_t y) {
  const uint32_t columns = static_cast<uint32_t>(x - reference_x_);
  const uint32_t rows = static_cast<uint32_t>(y - reference_y_);
  for (Weight& weight : weight_) {
    weight.value = weight.at_reference + columns * weight.by_column + rows * weight.by_row;
  }
}

FIXRAD_MODULO void TriangleShading::step() {
  for (Weight& weight : weight_) {
    weight.value += weight.by_column;
  }
}

SurfacePoint TriangleShading::point() const {
  uint32_t part[3];
  for (int i = 0; i < 3; ++i) {
    // Rounding may take a weight of 0 below it.
    part[i] = static_cast<int32_t>(weight_[i].value) < 0 ? 0u : weight_[i].value;
  }
  const uint32_t sum = part[0] + part[1] + part[2];
  if (sum == 0) {
    return {1, 0, 0};
  }
  const int shift = bit_length(sum) - 16;
  const uint32_t reciprocal = static_cast<uint32_t>(0x80000000ul / shifted(sum, shift));  // 2^15 .. 2^16
  SurfacePoint point;
  point.second = static_cast<int32_t>((shifted(part[1], shift) * reciprocal) >> 17);
  point.third = static_cast<int32_t>((shifted(part[2], shift) * reciprocal) >> 17);
  const int down = depth_shift_ + shift;
  const uint32_t depth = down > 31 || down < 0 ? 0 : (area_ * reciprocal) >> down;
  point.depth = static_cast<uint16_t>(depth < 1 ? 1 : (depth > kFarthest - 1u ? kFarthest - 1u : depth));
  return point;
}

}  // namespace fixrad

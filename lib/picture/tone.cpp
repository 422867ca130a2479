// SPDX-License-Identifier: MIT
#include "lib/picture/tone.h"

namespace fixrad {
namespace {

// Bits kept between two points of the curve, so that it rises wherever the curve in double does.
constexpr int kMoreBits = 4;

struct Curve {
  uint32_t gain, lift;  // with kMoreBits more than the points: UQ1.19, UQ0.20
};

uint32_t on_curve(uint32_t from, uint32_t to, uint32_t part, int bits) {
  const int32_t way = static_cast<int32_t>(to) - static_cast<int32_t>(from);
  const int32_t moved = floor_shift(way * static_cast<int32_t>(part), bits - kMoreBits);
  return static_cast<uint32_t>(static_cast<int32_t>(from << kMoreBits) + moved);
}

Curve curve_at(uint32_t peak) {
  if (peak < (1ul << kToneLow)) {
    return {1ul << (15 + kMoreBits), 0};
  }
  const int octave = bit_length(peak) - (kToneLow + 1);
  const int bits = octave + kToneLow - 4;  // of the position between two points, 6 .. 11
  const uint32_t step = (peak >> bits) & 15u;
  const unsigned point = static_cast<unsigned>(octave) * 16u + static_cast<unsigned>(step);
  const TonePoint low = flash_read(kToneCurve, point), high = flash_read(kToneCurve, point + 1);
  const uint32_t part = peak & ((static_cast<uint32_t>(1) << bits) - 1u);
  return {on_curve(low.gain, high.gain, part, bits), on_curve(low.lift, high.lift, part, bits)};
}

uint8_t srgb(uint32_t linear) {
  unsigned code = 0;
  for (unsigned step = 128; step != 0; step >>= 1) {
    if (flash_read(kSrgbThresholds, code + step - 1) <= linear) {
      code += step;
    }
  }
  return static_cast<uint8_t>(code);
}

}  // namespace

void display_pixel(const uint16_t* light, uint8_t channels, uint8_t* pixel) {
  uint16_t value[kMaxChannels];
  uint32_t peak = 0;
  for (uint8_t c = 0; c < channels; ++c) {
    value[c] = light[c];
    peak = value[c] > peak ? value[c] : peak;
  }
  const Curve curve = curve_at(peak);
  for (uint8_t c = 0; c < channels; ++c) {
    // UQ4.12 x UQ1.19 -> 31 bits and a little, since the product is at most the curve -> UQ0.16.
    const uint32_t linear = ((value[c] * curve.gain >> 11) + curve.lift) >> kMoreBits;
    pixel[c] = srgb(linear > 0xffffu ? 0xffffu : linear);
  }
}

}  // namespace fixrad

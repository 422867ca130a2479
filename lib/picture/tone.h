// SPDX-License-Identifier: MIT
#pragma once

#include "lib/picture/records.h"

namespace fixrad {

/// The factor from radiosity units to UQ4.12 light: `factor` / 2^shift.
struct Exposure {
  uint32_t factor;
  uint8_t shift;  ///< 0 .. 63
};

/// Light of a radiosity, saturating.
inline uint16_t expose(const Exposure& exposure, Radiosity radiosity) {
  const uint64_t light = wide_product(exposure.factor, radiosity.raw) >> exposure.shift;
  return static_cast<uint16_t>(saturate(light, Place::light_of_picture, kLightMax));
}

/// The tone curve's tables, host_sim/report/make_tone_table.cpp writes them. Up to 2^kToneLow (a quarter) the
/// curve is the identity; from there to 16 it is given at 16 points an octave: what a colour is multiplied
/// by, UQ1.15, and what is then added to all channels, so that the brightest fade to white, UQ0.16.
constexpr int kToneLow = kLightBits - 2;
constexpr int kTonePoints = 6 * 16 + 1;
struct TonePoint {
  uint16_t gain, lift;
};
extern const FIXRAD_IN_FLASH TonePoint kToneCurve[kTonePoints];

/// The sRGB code of a linear value (UQ0.16) is the number of these that it reaches (IEC 61966-2-1, rounded).
constexpr int kSrgbSteps = 255;
extern const FIXRAD_IN_FLASH uint16_t kSrgbThresholds[kSrgbSteps];

/// Light [channels] as sRGB bytes [channels]: the curve acts on the largest channel, the others keep their
/// ratio to it (host_sim/report/tone.h has it in double). `light` and `pixel` may be the same memory. Cost:
/// two interpolations and 8 comparisons a channel.
void display_pixel(const uint16_t* light, uint8_t channels, uint8_t* pixel);

}  // namespace fixrad

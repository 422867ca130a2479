// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/scene/scene.h"

namespace fixrad {

/// |found - wanted| of element radiosities over the scene's mean radiosity, millionths; of the worst channel.
struct RadiosityError {
  uint32_t mean, largest;
};

/// `wanted` [element][channel] in flash; `found(element, channel)` gives a float. Means are weighted by area,
/// as in `fixrad compare`. A channel without light does not count.
template <class Found>
RadiosityError radiosity_error(const Scene& scene, const FIXRAD_FLASH float* wanted, const Found& found) {
  constexpr float kMillion = 1.0e6f, kMost = 4.0e9f;
  RadiosityError worst = {0, 0};
  for (uint8_t c = 0; c < scene.channels; ++c) {
    float area = 0.0f, flux = 0.0f, difference = 0.0f, largest = 0.0f;
    for (uint16_t e = 0; e < scene.element_count; ++e) {
      const float own = static_cast<float>(flash_read(scene.elements, e).area);
      const float right = flash_read(wanted, static_cast<unsigned>(e) * scene.channels + c);
      const float off = __builtin_fabsf(found(e, c) - right);
      area += own;
      flux += own * right;
      difference += own * off;
      largest = off > largest ? off : largest;
    }
    if (flux > 0.0f) {
      const float mean_ppm = difference / flux * kMillion, largest_ppm = largest * area / flux * kMillion;
      const uint32_t mean = static_cast<uint32_t>(mean_ppm < kMost ? mean_ppm : kMost);
      const uint32_t most = static_cast<uint32_t>(largest_ppm < kMost ? largest_ppm : kMost);
      worst.mean = mean > worst.mean ? mean : worst.mean;
      worst.largest = most > worst.largest ? most : worst.largest;
    }
  }
  return worst;
}

}  // namespace fixrad

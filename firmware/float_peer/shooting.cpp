// SPDX-License-Identifier: MIT
#include "firmware/float_peer/shooting.h"

#include "firmware/float_peer/sampling.h"

namespace fixrad {
namespace peer {
namespace {

// As in the core: loans end while this many times the wanted unshot fraction is left.
constexpr float kOvershootUntil = 8.0f;

float* unshot_of(State& state, uint16_t patch) {
  return state.unshot + static_cast<uint32_t>(patch) * state.scene.channels;
}

struct Scan {
  uint16_t brightest;
  float brightest_flux;  // sum over channels
  Channels unshot;       // sum of magnitudes
};

// The number of channels is a constant here: this loop runs over all patches at every shot.
template <int ChannelCount>
void scan_patches(const float* unshot, uint16_t count, Scan& scan) {
  for (uint16_t p = 0; p < count; ++p) {
    float flux = 0.0f;
    for (int c = 0; c < ChannelCount; ++c) {
      const float m = __builtin_fabsf(*unshot++);
      scan.unshot.c[c] += m;
      flux = c == 0 ? m : flux + m;
    }
    if (flux > scan.brightest_flux) {
      scan.brightest_flux = flux;
      scan.brightest = p;
    }
  }
}

Scan scan_patches(const State& state) {
  Scan scan = {};
  const auto scan_channels = state.scene.channels == 1   ? scan_patches<1>
                             : state.scene.channels == 2 ? scan_patches<2>
                                                         : scan_patches<3>;
  scan_channels(state.unshot, state.scene.patch_count, scan);
  return scan;
}

bool is_converged(const State& state, const Scan& scan, float factor) {
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    if (scan.unshot.c[c] > factor * state.stop * state.emitted.c[c]) {
      return false;
    }
  }
  return true;
}

uint16_t wanted_eyes(const State& state, const Scan& scan) {
  float emitted = 0.0f;
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    emitted += state.emitted.c[c];
  }
  const float an_eye = emitted * state.flux_per_eye;
  if (scan.brightest_flux >= static_cast<float>(kMaxEyes) * an_eye) {
    return kMaxEyes;
  }
  const float wanted = scan.brightest_flux / an_eye;
  const uint16_t whole = static_cast<uint16_t>(wanted);
  return static_cast<float>(whole) < wanted ? static_cast<uint16_t>(whole + 1) : whole;
}

float patch_area(const Scene& scene, const Patch& patch) {
  uint32_t area = 0;  // at most the largest plane section of the grid, below 2^32
  for (uint16_t i = 0; i < patch.element_count; ++i) {
    const uint16_t e = flash_read(scene.patch_elements, static_cast<unsigned>(patch.first_element) + i);
    area += flash_read(scene.elements, e).area;
  }
  return static_cast<float>(area);
}

// What the patch will still receive if the ambient estimate is right, but never more than its own unshot
// flux.
void add_loans(const State& state, uint16_t index, Channels& amount) {
  const Patch patch = flash_read(state.scene.patches, index);
  const uint16_t material = flash_read(state.scene.faces, patch.face).material;
  const Channels reflectance = reflectance_of(state.scene, material);
  const float area = patch_area(state.scene, patch);
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    float balance = 0.0f;
    const float* unshot = state.unshot + c;
    for (uint16_t p = 0; p < state.scene.patch_count; ++p, unshot += state.scene.channels) {
      balance += *unshot;
    }
    if (amount.c[c] > 0.0f && balance > 0.0f && state.absorbing_area.c[c] > 0.0f) {
      const float loan = reflectance.c[c] * balance * area / state.absorbing_area.c[c];
      amount.c[c] += loan < amount.c[c] ? loan : amount.c[c];
    }
  }
}

// What one unit of the row brings.
struct Parts {
  Channels sent, reflected;
};

template <int ChannelCount>
void distribute(State& state, const Channels& sent) {
  const Scene& scene = state.scene;
  Parts part = {sent, {}};
  uint16_t material = 0xffff;  // of part.reflected; elements are ordered by face
  float* received = state.received;
  for (uint16_t e = 0; e < scene.element_count; ++e, received += ChannelCount) {
    const float share = state.row.share[e];
    if (share == 0.0f) {
      continue;
    }
    const Element element = flash_read(scene.elements, e);
    if (element.material != material) {
      material = element.material;
      const Channels reflectance = reflectance_of(scene, material);
      for (int c = 0; c < ChannelCount; ++c) {
        part.reflected.c[c] = sent.c[c] * reflectance.c[c];
      }
    }
    float* unshot = unshot_of(state, element.patch);
    for (int c = 0; c < ChannelCount; ++c) {
      received[c] += part.sent.c[c] * share;
      unshot[c] += part.reflected.c[c] * share;
    }
  }
  for (int c = 0; c < ChannelCount; ++c) {
    state.escaped.c[c] += sent.c[c] * state.row.escaped;
    state.back.c[c] += sent.c[c] * state.row.back;
  }
}

}  // namespace

Status shoot(State& state) {
  const Scan scan = scan_patches(state);
  if (is_converged(state, scan, 1.0f)) {
    return Status::converged;
  }
  const EyeSource source = patch_source(state.scene, scan.brightest);
  const Status status =
      sample_source(state, source, wanted_eyes(state, scan), state.known_eyes[scan.brightest]);
  if (status != Status::ok) {
    return status;
  }
  Channels amount = {};
  float* unshot = unshot_of(state, scan.brightest);
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    amount.c[c] = unshot[c];
  }
  if (state.overshoot && !is_converged(state, scan, kOvershootUntil)) {
    add_loans(state, scan.brightest, amount);
  }
  const float part_of_shot = 1.0f / state.row.whole;
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    unshot[c] -= amount.c[c];
    amount.c[c] *= part_of_shot;
  }
  const auto distribute_channels = state.scene.channels == 1   ? distribute<1>
                                   : state.scene.channels == 2 ? distribute<2>
                                                               : distribute<3>;
  distribute_channels(state, amount);
  ++state.shots;
  return Status::ok;
}

}  // namespace peer
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "lib/transport/shooting.h"

#include "lib/fixed/cutter.h"
#include "lib/transport/sampling.h"

namespace fixrad {
namespace {

// Overshooting ends while this many times the wanted unshot fraction is left; plain shooting, which only ever
// lowers the sum of unshot flux, finishes.
constexpr uint64_t kOvershootUntil = 8;

// 2^32 over the golden ratio: the roundings of successive shots are spread evenly.
constexpr uint32_t kGoldenStep = 0x9e3779b9u;

int32_t* unshot_of(State& state, uint16_t patch) {
  return state.unshot + static_cast<uint32_t>(patch) * state.scene.channels;
}

struct Scan {
  uint16_t brightest;
  uint64_t brightest_flux;        // sum over channels
  uint64_t unshot[kMaxChannels];  // sum of magnitudes
  int64_t balance[kMaxChannels];  // sum with signs
};

// The number of channels is a constant here: this loop runs over all patches at every shot.
template <int Channels>
void scan_patches(const int32_t* unshot, uint16_t count, Scan& scan) {
  for (uint16_t p = 0; p < count; ++p) {
    uint64_t flux = 0;
    for (int c = 0; c < Channels; ++c) {
      const int32_t own = *unshot++;
      const uint32_t m = magnitude(own);
      scan.unshot[c] += m;
      scan.balance[c] += own;
      flux += m;
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

uint64_t part_of_emitted(const State& state, Fraction part, int c) {
  return (static_cast<uint64_t>(part.raw) * static_cast<uint32_t>(state.emitted[c])) >> 32;
}

bool is_converged(const State& state, const Scan& scan, uint64_t factor) {
  for (int c = 0; c < state.scene.channels; ++c) {
    if (scan.unshot[c] > factor * part_of_emitted(state, state.settings.stop, c)) {
      return false;
    }
  }
  return true;
}

uint32_t wanted_eyes(const State& state, const Scan& scan) {
  uint64_t an_eye = 0;
  for (int c = 0; c < state.scene.channels; ++c) {
    an_eye += part_of_emitted(state, state.settings.flux_per_eye, c);
  }
  const uint64_t wanted = an_eye == 0 ? kMaxEyes : (scan.brightest_flux + an_eye - 1) / an_eye;
  return static_cast<uint32_t>(wanted < kMaxEyes ? wanted : kMaxEyes);
}

// What the patch will still receive if the ambient estimate is right, but never more than its own unshot
// flux: larger loans were seen to diverge.
int32_t loan(const State& state, uint16_t patch, int c, int32_t unshot, Radiosity ambient) {
  const Scene& scene = state.scene;
  const Patch p = flash_read(scene.patches, patch);
  uint64_t area = 0;
  for (unsigned i = 0; i < p.element_count; ++i) {
    const uint16_t e = flash_read(scene.patch_elements, p.first_element + i);
    area += flash_read(scene.elements, e).area;
  }
  const Material material = flash_read(scene.materials, flash_read(scene.faces, p.face).material);
  const uint64_t radiosity = mul_high(material.reflectance[c], ambient.raw);
  const uint64_t flux = (radiosity * area) >> scene.radiosity_shift;
  return flux < static_cast<uint64_t>(unshot) ? static_cast<int32_t>(flux) : unshot;
}

void distribute(State& state, const Flux* amount) {
  const Scene& scene = state.scene;
  const int channels = scene.channels;
  const uint32_t phase = (state.shots * kGoldenStep) >> 12;
  FluxCutter cutter[kMaxChannels] = {{amount[0], phase}, {amount[1], phase}, {amount[2], phase}};
  uint32_t left = kRowOne - state.row.escaped;
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    const uint32_t part = state.row.share[e];
    if (part == 0) {
      continue;
    }
    left -= part;
    const Element& element = flash_at(scene.elements, e);
    const Material& material = flash_at(scene.materials, element.material);
    int32_t* received = state.received + static_cast<uint32_t>(e) * scene.channels;
    int32_t* unshot = unshot_of(state, element.patch);
    for (int c = 0; c < channels; ++c) {
      const Flux share = cutter[c].cut(part);
      const Reflectance reflectance = Reflectance::from_raw(material.reflectance[c]);
      unshot[c] += reflect_more(reflectance, Flux::from_raw(received[c]), share).raw;
      received[c] += share.raw;
    }
  }
  for (int c = 0; c < channels; ++c) {
    state.escaped[c] += cutter[c].cut(state.row.escaped).raw;
    state.back[c] += cutter[c].cut(left).raw;
  }
}

}  // namespace

Fraction unshot_fraction(const State& state) {
  uint64_t worst = 0;
  for (int c = 0; c < state.scene.channels; ++c) {
    const uint64_t emitted = static_cast<uint32_t>(state.emitted[c]);
    const uint64_t part = emitted == 0 ? 0 : (unshot_magnitude(state, c) << 32) / emitted;
    worst = part > worst ? part : worst;
  }
  return Fraction::from_raw(worst > 0xffffffffu ? 0xffffffffu : static_cast<uint32_t>(worst));
}

Status shoot(State& state) {
  const Scan scan = scan_patches(state);
  if (is_converged(state, scan, 1)) {
    return Status::converged;
  }
  const EyeSource source = patch_source(state.scene, scan.brightest);
  const Status status =
      sample_source(state, source, wanted_eyes(state, scan), state.known_eyes[scan.brightest]);
  if (status != Status::ok) {
    return status;
  }
  if (state.settings.near_field != nullptr) {
    state.settings.near_field(state.scene, source, state.work, state.row);
  }
  const bool overshoots = state.settings.overshoot && !is_converged(state, scan, kOvershootUntil);
  Flux amount[kMaxChannels] = {};
  int32_t* unshot = unshot_of(state, scan.brightest);
  for (int c = 0; c < state.scene.channels; ++c) {
    amount[c].raw = unshot[c];
    if (overshoots && unshot[c] > 0) {
      amount[c].raw += loan(state, scan.brightest, c, unshot[c], ambient_of(state, c, scan.balance[c]));
    }
  }
  const Observer& observer = state.settings.observer;
  if (observer.on_shot != nullptr) {
    observer.on_shot(observer.context, scan.brightest, amount, overshoots);
  }
  for (int c = 0; c < state.scene.channels; ++c) {
    unshot[c] -= amount[c].raw;
  }
  distribute(state, amount);
  ++state.shots;
  return Status::ok;
}

}  // namespace fixrad

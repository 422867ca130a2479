// SPDX-License-Identifier: MIT
#include "lib/transport/state.h"

namespace fixrad {
namespace {

Material material_of(const Scene& scene, const Element& element) {
  return flash_read(scene.materials, element.material);
}

uint32_t saturate(uint64_t a) {
  return a > 0xffffffffu ? 0xffffffffu : static_cast<uint32_t>(a);
}

}  // namespace

void reset(State& state, const Scene& scene, const Settings& settings) {
  state.scene = scene;
  state.settings = settings;
  state.row.count = scene.element_count;
  state.work.span_high_water = 0;
  state.work.gaps_closed = 0;
  state.shots = state.eyes = state.withdrawn = 0;
  state.turn = 0;
  state.is_closed = is_closed(scene);
  state.is_enclosed = state.is_closed && is_enclosed(scene);
  const unsigned channels = scene.channels;
  for (unsigned i = 0; i < scene.patch_count; ++i) {
    state.known_eyes[i] = 0;
  }
  for (uint32_t i = 0; i < static_cast<uint32_t>(scene.patch_count) * channels; ++i) {
    state.unshot[i] = 0;
  }
  for (uint32_t i = 0; i < static_cast<uint32_t>(scene.element_count) * channels; ++i) {
    state.received[i] = 0;
  }
  for (unsigned c = 0; c < channels; ++c) {
    state.emitted[c] = state.escaped[c] = state.back[c] = 0;
    state.absorbing_area[c] = 0;
    for (uint16_t e = 0; e < scene.element_count; ++e) {
      const Element element = flash_read(scene.elements, e);
      const Material material = material_of(scene, element);
      const Flux flux = emitted_flux(scene, material, element.area, static_cast<int>(c));
      state.absorbing_area[c] += element.area - mul_high(material.reflectance[c], element.area);
      state.unshot[element.patch * channels + c] += flux.raw;
      state.emitted[c] += flux.raw;
    }
  }
}

Ledger ledger(const State& state, int c) {
  const Scene& scene = state.scene;
  Ledger sum = {state.emitted[c], 0, 0, state.escaped[c], state.back[c]};
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    const Material material = material_of(scene, flash_read(scene.elements, e));
    const Flux received =
        Flux::from_raw(state.received[static_cast<uint32_t>(e) * scene.channels + static_cast<unsigned>(c)]);
    sum.absorbed += received.raw - reflect(Reflectance::from_raw(material.reflectance[c]), received).raw;
  }
  for (uint16_t p = 0; p < scene.patch_count; ++p) {
    sum.unshot += state.unshot[static_cast<uint32_t>(p) * scene.channels + static_cast<unsigned>(c)];
  }
  return sum;
}

uint64_t unshot_magnitude(const State& state, int c) {
  uint64_t sum = 0;
  for (uint16_t p = 0; p < state.scene.patch_count; ++p) {
    sum +=
        magnitude(state.unshot[static_cast<uint32_t>(p) * state.scene.channels + static_cast<unsigned>(c)]);
  }
  return sum;
}

Flux exitent_flux(const State& state, uint16_t e, int c) {
  const Element element = flash_read(state.scene.elements, e);
  const Material material = material_of(state.scene, element);
  const Flux received = Flux::from_raw(
      state.received[static_cast<uint32_t>(e) * state.scene.channels + static_cast<unsigned>(c)]);
  const Flux flux = emitted_flux(state.scene, material, element.area, c) +
                    reflect(Reflectance::from_raw(material.reflectance[c]), received);
  return flux.raw < 0 ? Flux::from_raw(0) : flux;
}

Radiosity ambient_radiosity(const State& state, int c) {
  int64_t unshot = 0;
  for (uint16_t p = 0; p < state.scene.patch_count; ++p) {
    unshot += state.unshot[static_cast<uint32_t>(p) * state.scene.channels + static_cast<unsigned>(c)];
  }
  return ambient_of(state, c, unshot);
}

// (unshot / area) / (1 - mean reflectance) = unshot / absorbing area. Unshot flux is below 2^31 and the shift
// at most 32, so the dividend fits.
Radiosity ambient_of(const State& state, int c, int64_t unshot) {
  if (unshot <= 0 || state.absorbing_area[c] == 0) {
    return Radiosity::from_raw(0);
  }
  return Radiosity::from_raw(
      saturate((static_cast<uint64_t>(unshot) << state.scene.radiosity_shift) / state.absorbing_area[c]));
}

Radiosity element_radiosity(const State& state, uint16_t e, int c, Radiosity ambient) {
  const Element element = flash_read(state.scene.elements, e);
  const uint64_t flux = static_cast<uint64_t>(exitent_flux(state, e, c).raw);
  const uint64_t own = (flux << state.scene.radiosity_shift) / element.area;
  const uint32_t reflectance = material_of(state.scene, element).reflectance[c];
  return Radiosity::from_raw(saturate(own + mul_high(reflectance, ambient.raw)));
}

}  // namespace fixrad

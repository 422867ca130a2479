// SPDX-License-Identifier: MIT
#include "lib/transport/state.h"

#include "lib/transport/unshot.h"

namespace fixrad {
namespace {

Material material_of(const Scene& scene, const Element& element) {
  return flash_read(scene.materials, element.material);
}

Flux received_flux(const State& state, uint16_t e, int c) {
  return Flux::from_raw(
      state.received[static_cast<uint32_t>(e) * state.scene.channels + static_cast<unsigned>(c)]);
}

// A part of the flux in units of four, so that fluxes of three channels fit 32 bits; at least 1.
uint32_t quarter_part(uint64_t flux, Fraction part) {
  const uint32_t quarters = mul_high(static_cast<uint32_t>(flux >> 2), part.raw);
  return quarters > 0 ? quarters : 1;
}

}  // namespace

void reset(State& state, const Scene& scene, const Settings& settings) {
  state.scene = scene;
  state.settings = settings;
  state.row.count = scene.element_count;
  state.work.span_high_water = 0;
  state.work.gaps_closed = 0;
  state.work.budget = 0;
  forget_view(state.work);
  state.sampling = {};
  state.shots = state.eyes = state.withdrawn = 0;
  state.turn = 0;
  state.is_closed = is_closed(scene);
  state.is_enclosed = state.is_closed && is_enclosed(scene);
  state.next_emitter = 0;
  const unsigned channels = scene.channels;
  for (uint32_t i = 0; i < channels * account_words(scene.element_count, scene.face_count); ++i) {
    state.accounts[i] = 0;
  }
  for (uint32_t i = 0; i < static_cast<uint32_t>(scene.element_count) * channels; ++i) {
    state.received[i] = 0;
  }
  uint64_t emitted = 0;
  for (unsigned c = 0; c < channels; ++c) {
    state.emitted[c] = state.escaped[c] = state.back[c] = 0;
    state.absorbing_area[c] = 0;
    for (uint16_t e = 0; e < scene.element_count; ++e) {
      const Element element = flash_read(scene.elements, e);
      const Material material = material_of(scene, element);
      state.absorbing_area[c] += element.area - mul_high(material.reflectance[c], element.area);
      state.emitted[c] += emitted_flux(scene, material, element.area, static_cast<int>(c)).raw;
    }
    emitted += static_cast<uint32_t>(state.emitted[c]);
  }
  emitted = flux_meant(emitted, scene.channels);
  state.a_row = quarter_part(emitted, settings.flux_per_row);
  state.an_eye = quarter_part(emitted, settings.flux_per_eye);
  state.sweep = {SourceKind::element, scene.element_count, true, false, 0, {}};
}

Ledger ledger(const State& state, int c) {
  const Scene& scene = state.scene;
  Ledger sum = {state.emitted[c], 0, sum_unshot(state, c).balance, state.escaped[c], state.back[c]};
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    sum.absorbed += received_flux(state, e, c).raw - reflected_flux(state, e, c).raw;
  }
  return sum;
}

Flux reflected_flux(const State& state, uint16_t e, int c) {
  const Element& element = flash_at(state.scene.elements, e);
  const Material& material = flash_at(state.scene.materials, element.material);
  return reflect(Reflectance::from_raw(material.reflectance[c]), received_flux(state, e, c));
}

Flux exitent_flux(const State& state, uint16_t e, int c) {
  const Element& element = flash_at(state.scene.elements, e);
  const Material& material = flash_at(state.scene.materials, element.material);
  const Flux flux = emitted_flux(state.scene, material, element.area, c) + reflected_flux(state, e, c);
  return flux.raw < 0 ? Flux::from_raw(0) : flux;
}

Radiosity ambient_radiosity(const State& state, int c) {
  return ambient_of(state, c, sum_unshot(state, c).balance);
}

// (unshot / area) / (1 - mean reflectance) = unshot / absorbing area. Unshot flux is below 2^31 and the shift
// at most 32, so the dividend fits.
Radiosity ambient_of(const State& state, int c, int64_t unshot) {
  if (unshot <= 0 || state.absorbing_area[c] == 0) {
    return Radiosity::from_raw(0);
  }
  return Radiosity::from_raw(
      saturate((static_cast<uint64_t>(unshot) << state.scene.radiosity_shift) / state.absorbing_area[c],
               Place::ambient_radiosity));
}

Radiosity element_radiosity(const State& state, uint16_t e, int c, Radiosity ambient) {
  const Element element = flash_read(state.scene.elements, e);
  const uint64_t flux = static_cast<uint64_t>(exitent_flux(state, e, c).raw);
  const uint64_t own = (flux << state.scene.radiosity_shift) / element.area;
  const uint32_t reflectance = material_of(state.scene, element).reflectance[c];
  return Radiosity::from_raw(saturate(own + mul_high(reflectance, ambient.raw), Place::element_radiosity));
}

}  // namespace fixrad

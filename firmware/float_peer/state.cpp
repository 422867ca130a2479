// SPDX-License-Identifier: MIT
#include "firmware/float_peer/state.h"

namespace fixrad {
namespace peer {
namespace {

float power_of_two(int exponent) {
  float power = 1.0f;
  for (; exponent > 0; --exponent) {
    power *= 2.0f;
  }
  for (; exponent < 0; ++exponent) {
    power *= 0.5f;
  }
  return power;
}

uint32_t index_of(const State& state, uint16_t element, uint8_t channel) {
  return static_cast<uint32_t>(element) * state.scene.channels + channel;
}

void clear_light(State& state) {
  const uint32_t values = static_cast<uint32_t>(state.scene.element_count) * state.scene.channels;
  for (uint32_t i = 0; i < values; ++i) {
    state.received[i] = state.accounts[i] = 0.0f;
  }
  state.emitted = state.escaped = state.back = state.absorbing_area = {};
}

void emit(State& state, uint16_t e) {
  const Element element = flash_read(state.scene.elements, e);
  const Channels reflectance = reflectance_of(state.scene, element.material);
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    state.emitted.c[c] += emitted_flux(state, e, c);
    state.absorbing_area.c[c] += (1.0f - reflectance.c[c]) * static_cast<float>(element.area);
  }
}

}  // namespace

float fraction_of_one(uint32_t raw) {
  return static_cast<float>(raw) * (1.0f / 4294967296.0f);
}

Channels reflectance_of(const Scene& scene, uint16_t material) {
  const Material m = flash_read(scene.materials, material);
  return {{fraction_of_one(m.reflectance[0]), fraction_of_one(m.reflectance[1]),
           fraction_of_one(m.reflectance[2])}};
}

float emitted_flux(const State& state, uint16_t element, uint8_t channel) {
  const Element& e = flash_at(state.scene.elements, element);
  const uint32_t emission = flash_at(state.scene.materials, e.material).emission[channel];
  return emission == 0 ? 0.0f
                       : static_cast<float>(emission) * state.emission_unit * static_cast<float>(e.area);
}

void reset(State& state, const Scene& scene, const Settings& settings) {
  state.scene = scene;
  state.coarsest = flash_at(settings.tables, 0).resolution_log2;
  state.finest = static_cast<uint8_t>(state.coarsest + settings.table_count - 1);
  state.probe = lune_table(flash_at(settings.probe, 0).resolution_log2);
  state.stop = fraction_of_one(settings.stop.raw);
  state.overshoot = settings.overshoot;
  state.emission_unit = power_of_two(-scene.emission_shift);
  state.radiosity_unit = power_of_two(scene.radiosity_shift);
  state.row.count = scene.element_count;
  state.shots = state.eyes = state.withdrawn = 0;
  state.turn = 0;
  state.is_closed = is_closed(scene);
  state.is_enclosed = state.is_closed && is_enclosed(scene);
  state.next_emitter = 0;
  clear_light(state);
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    emit(state, e);
  }
  float emitted = 0.0f;
  for (uint8_t c = 0; c < scene.channels; ++c) {
    emitted += state.emitted.c[c];
  }
  state.a_row = emitted * fraction_of_one(settings.flux_per_row.raw);
  state.an_eye = emitted * fraction_of_one(settings.flux_per_eye.raw);
  state.sweep = {SourceKind::element, scene.element_count, true, 0.0f, {}};
}

float exitent_flux(const State& state, uint16_t element, uint8_t channel) {
  const Element& e = flash_at(state.scene.elements, element);
  const uint32_t reflectance = flash_at(state.scene.materials, e.material).reflectance[channel];
  const float flux = emitted_flux(state, element, channel) +
                     fraction_of_one(reflectance) * state.received[index_of(state, element, channel)];
  return flux < 0.0f ? 0.0f : flux;
}

float element_radiosity(const State& state, uint16_t element, uint8_t channel) {
  const float area = static_cast<float>(flash_read(state.scene.elements, element).area);
  return exitent_flux(state, element, channel) * state.radiosity_unit / area;
}

namespace {

float mean_round(const State& state, const VertexMap& map, const MeshVertex& v, uint8_t channel) {
  float sum = 0.0f;
  for (uint8_t i = 0; i < v.count; ++i) {
    const uint16_t e = flash_read(map.elements + v.first, i);
    sum += element_radiosity(state, e, channel);
  }
  return sum / static_cast<float>(v.count);
}

}  // namespace

float vertex_radiosity(const State& state, const VertexMap& map, uint32_t vertex, uint8_t channel) {
  const MeshVertex v = flash_read(map.vertices + vertex, 0);
  const float mean = mean_round(state, map, v, channel);
  if (v.inner == kNoVertex) {
    return mean;
  }
  const float inner = mean_round(state, map, flash_read(map.vertices + v.inner, 0), channel);
  return mean + mean > inner ? mean + mean - inner : 0.0f;
}

}  // namespace peer
}  // namespace fixrad

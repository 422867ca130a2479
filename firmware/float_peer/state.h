// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/rows.h"
#include "lib/transport/state.h"
#include "lib/vertices/vertex_radiosity.h"

namespace fixrad {
namespace peer {

/// One value a channel.
struct Channels {
  float c[kMaxChannels];
};

/// Everything a peer knows. Fluxes and radiosities are in the scene's units, as the core's. The arrays belong
/// to the storage.
struct State {
  Scene scene;
  LuneTable table, coarse, probe;
  float stop, flux_per_eye;  ///< fractions of the emitted flux
  bool overshoot;
  Workspace work;
  FormFactorRow row;
  float* received;        ///< [element][channel], flux received in all
  float* unshot;          ///< [patch][channel]
  KnownEyes* known_eyes;  ///< [patch]
  Channels emitted, escaped, back;
  Channels absorbing_area;  ///< sum of (1 - reflectance) area, 1/8 square grid unit
  float emission_unit;      ///< 2^-emission_shift
  float radiosity_unit;     ///< 2^radiosity_shift
  uint32_t shots, eyes, withdrawn;
  uint8_t turn;
  bool is_closed, is_enclosed;
};

/// The settings' table for shots from one eye point.
inline const FIXRAD_FLASH fixrad::DeltaTable* coarse_table(const Settings& settings) {
  return settings.coarse != nullptr ? settings.coarse : settings.table;
}

/// Puts `scene` into `state`: nothing received, every emitter's flux unshot. The caller has checked the
/// scene.
void reset(State& state, const Scene& scene, const Settings& settings);

/// 0 .. 1 of a UQ0.32.
float fraction_of_one(uint32_t raw);

/// Reflectance of a material, one value a channel.
Channels reflectance_of(const Scene& scene, uint16_t material);

/// Flux that an element emits by itself.
float emitted_flux(const State& state, uint16_t element, uint8_t channel);

/// Flux that an element has emitted and reflected in all; never negative.
float exitent_flux(const State& state, uint16_t element, uint8_t channel);

/// Radiosity of an element, in the unit of the core's Radiosity.
float element_radiosity(const State& state, uint16_t element, uint8_t channel);

/// As the core's vertex_radiosity(), without the ambient estimate.
float vertex_radiosity(const State& state, const VertexMap& map, uint32_t vertex, uint8_t channel);

}  // namespace peer
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/rows.h"
#include "lib/elements/eye_points.h"
#include "lib/transport/state.h"
#include "lib/vertices/vertex_radiosity.h"

namespace fixrad {
namespace peer {

/// One value a channel.
struct Channels {
  float c[kMaxChannels];
};

/// Who shoots next, and when, as the core's fixrad::Sweep.
struct Sweep {
  SourceKind kind;
  uint16_t cursor;  ///< next element (also of a face: its first) or patch
  bool has_shot;    ///< in this pass
  float threshold;  ///< flux, sum over channels
  Channels loan;    ///< flux lent in this pass to a reflectance and an area of 1; 0 without overshooting
};

/// Everything a peer knows. Fluxes and radiosities are in the scene's units, as the core's. The arrays belong
/// to the storage.
struct State {
  Scene scene;
  uint8_t coarsest, finest;  ///< log2 of the fewest and of the most lunes of an eye
  LuneTable probe;
  float stop;  ///< fraction of the emitted flux
  bool overshoot;
  Workspace work;
  FormFactorRow row;
  float* received;  ///< [element][channel], flux received in all
  float* accounts;  ///< [element][channel], see unshot.h
  Channels emitted, escaped, back;
  Channels absorbing_area;  ///< sum of (1 - reflectance) area, 1/8 square grid unit
  float a_row, an_eye;      ///< flux that deserves a row, or an eye point, all channels
  float emission_unit;      ///< 2^-emission_shift
  float radiosity_unit;     ///< 2^radiosity_shift
  uint32_t shots, eyes, withdrawn;
  Sweep sweep;
  uint16_t next_emitter;  ///< elements before it have sent what they emit
  uint8_t turn;
  bool is_closed, is_enclosed;
};

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

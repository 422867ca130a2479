// SPDX-License-Identifier: MIT
#include "lib/vertices/digest.h"

namespace fixrad {
namespace {

FIXRAD_MODULO uint64_t mix(uint64_t hash, uint32_t word) {
  for (int i = 0; i < 4; ++i) {
    hash = (hash ^ ((word >> (8 * i)) & 0xffu)) * 1099511628211u;
  }
  return hash;
}

uint64_t received_digest(const State& state) {
  uint64_t hash = 14695981039346656037u;
  const uint32_t count = static_cast<uint32_t>(state.scene.element_count) * state.scene.channels;
  for (uint32_t i = 0; i < count; ++i) {
    hash = mix(hash, static_cast<uint32_t>(state.received[i]));
  }
  return hash;
}

}  // namespace

uint64_t digest(const State& state, const VertexMap& map) {
  uint64_t hash = received_digest(state);
  for (uint32_t v = 0; v < map.vertex_count; ++v) {
    for (int c = 0; c < state.scene.channels; ++c) {
      hash = mix(hash, vertex_radiosity(state, map, v, c, Radiosity::from_raw(0)).raw);
    }
  }
  return hash;
}

uint64_t digest(const State& state, const Radiosity* displayed, uint32_t count) {
  uint64_t hash = received_digest(state);
  for (uint32_t i = 0; i < count; ++i) {
    hash = mix(hash, displayed[i].raw);
  }
  return hash;
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "lib/vertices/digest.h"

#include "lib/fixed/fnv1a.h"

namespace fixrad {
namespace {

uint64_t received_digest(const State& state) {
  uint64_t hash = kFnvOfNothing;
  const uint32_t count = static_cast<uint32_t>(state.scene.element_count) * state.scene.channels;
  for (uint32_t i = 0; i < count; ++i) {
    hash = fnv1a(hash, static_cast<uint32_t>(state.received[i]));
  }
  return hash;
}

}  // namespace

uint64_t digest(const State& state, const VertexMap& map) {
  uint64_t hash = received_digest(state);
  for (uint32_t v = 0; v < map.vertex_count; ++v) {
    for (int c = 0; c < state.scene.channels; ++c) {
      hash = fnv1a(hash, vertex_radiosity(state, map, v, c, Radiosity::from_raw(0)).raw);
    }
  }
  return hash;
}

uint64_t digest(const State& state, const Radiosity* displayed, uint32_t count) {
  uint64_t hash = received_digest(state);
  for (uint32_t i = 0; i < count; ++i) {
    hash = fnv1a(hash, displayed[i].raw);
  }
  return hash;
}

}  // namespace fixrad

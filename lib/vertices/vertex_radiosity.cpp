// SPDX-License-Identifier: MIT
#include "lib/vertices/vertex_radiosity.h"

namespace fixrad {
namespace {

uint32_t mean_round(const State& state, const VertexMap& map, const MeshVertex& v, int channel,
                    Radiosity ambient) {
  uint64_t sum = 0;
  for (unsigned i = 0; i < v.count; ++i) {
    const uint16_t e = flash_read(map.elements, static_cast<unsigned>(v.first + i));
    sum += element_radiosity(state, e, channel, ambient).raw;
  }
  return static_cast<uint32_t>(sum / v.count);
}

}  // namespace

Radiosity vertex_radiosity(const State& state, const VertexMap& map, uint32_t vertex, int channel,
                           Radiosity ambient) {
  const MeshVertex v = flash_read(map.vertices, static_cast<unsigned>(vertex));
  const uint32_t mean = mean_round(state, map, v, channel, ambient);
  if (v.inner == kNoVertex) {
    return Radiosity::from_raw(mean);
  }
  const uint32_t inner =
      mean_round(state, map, flash_read(map.vertices, static_cast<unsigned>(v.inner)), channel, ambient);
  const uint64_t twice = 2 * static_cast<uint64_t>(mean);
  const uint64_t border = twice > inner ? twice - inner : 0;
  return Radiosity::from_raw(saturate(border, Place::vertex_radiosity));
}

}  // namespace fixrad

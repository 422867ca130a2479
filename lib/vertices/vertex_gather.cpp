// SPDX-License-Identifier: MIT
#include "lib/vertices/vertex_gather.h"

#include "lib/transport/shooting.h"

namespace fixrad {
namespace {

// Emission is flux an area unit times 2^emission_shift, radiosity the same times 2^radiosity_shift.
uint64_t emitted_radiosity(const Scene& scene, uint32_t emission) {
  return (static_cast<uint64_t>(emission) << scene.radiosity_shift) >> scene.emission_shift;
}

Radiosity leaving(const Scene& scene, const Material& material, int channel, Radiosity irradiance) {
  const uint64_t sum = emitted_radiosity(scene, material.emission[channel]) +
                       mul_high(material.reflectance[channel], irradiance.raw);
  return Radiosity::from_raw(saturate(sum, Place::gathered_radiosity));
}

Status gather_if_clear(State& state, const DeltaTable& table, DirectLight direct, const EyePoint& eye,
                       const Radiosity* ambient, Irradiance& irradiance, bool& is_clear) {
  uint32_t hidden = 0;
  const Status status = hidden_share(state.scene, flash_read(state.settings.probe, 0), eye, state.is_enclosed,
                                     state.work, hidden);
  is_clear = status == Status::ok && hidden <= kBuriedShare;
  return is_clear ? gather_irradiance(state, table, direct, eye, true, ambient, irradiance) : status;
}

}  // namespace

Status gather_vertex(State& state, const DeltaTable& table, DirectLight direct,
                     const FIXRAD_FLASH GatherPoint* points, uint8_t count, uint8_t enough,
                     const Radiosity* ambient, VertexLight& light) {
  abandon_shot(state);
  const Scene& scene = state.scene;
  uint64_t sum[kMaxChannels] = {0, 0, 0};
  light.clear_points = 0;
  for (uint8_t i = 0; i < count && light.clear_points < enough; ++i) {
    const GatherPoint point = flash_read(points, i);
    const uint16_t face = flash_at(scene.elements, point.element).face;
    const EyePoint eye = {vec(point.position), face, static_cast<uint8_t>(i % kTurns)};
    Irradiance irradiance = {};
    bool is_clear = false;
    const Status status = gather_if_clear(state, table, direct, eye, ambient, irradiance, is_clear);
    if (status != Status::ok) {
      return status;
    }
    for (int c = 0; is_clear && c < scene.channels; ++c) {
      sum[c] += irradiance.of[c].raw;
    }
    light.clear_points = static_cast<uint8_t>(light.clear_points + (is_clear ? 1 : 0));
  }
  const uint16_t first = flash_read(points, 0).element;
  const Material material = flash_read(scene.materials, flash_at(scene.elements, first).material);
  for (int c = 0; c < kMaxChannels; ++c) {
    const bool is_lit = c < scene.channels && light.clear_points > 0;
    light.irradiance[c] =
        Radiosity::from_raw(is_lit ? static_cast<uint32_t>(sum[c] / light.clear_points) : 0u);
    light.radiosity[c] = is_lit ? leaving(scene, material, c, light.irradiance[c]) : Radiosity::from_raw(0);
  }
  return Status::ok;
}

}  // namespace fixrad

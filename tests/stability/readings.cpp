// SPDX-License-Identifier: MIT
#include "tests/stability/readings.h"

#include <algorithm>
#include <cmath>

namespace fixrad::host {
namespace {

Light empty_light(const DeviceScene& device) {
  Light light = {};
  light.device = &device;
  const std::size_t values = device.elements.size() * static_cast<std::size_t>(device.channels);
  light.received.assign(values, 0.0);
  light.radiosity.assign(values, 0.0);
  return light;
}

// What a part of nothing is: a channel may be dark.
double part_of(double flux, double emitted) {
  return emitted > 0 ? flux / emitted : flux;
}

}  // namespace

Light read_core(const DeviceScene& device, const State& state) {
  Light light = empty_light(device);
  for (std::uint8_t c = 0; c < state.scene.channels; ++c) {
    const double emitted = state.emitted[c];
    for (std::uint16_t e = 0; e < state.scene.element_count; ++e) {
      const std::size_t i = std::size_t{e} * state.scene.channels + c;
      light.radiosity[i] = element_radiosity(state, e, c, Radiosity::from_raw(0)).raw * device.unit_radiosity;
      light.received[i] = part_of(state.received[i], emitted);
    }
    light.escaped[c] = part_of(state.escaped[c], emitted);
    light.back[c] = part_of(state.back[c], emitted);
    light.unshot[c] = part_of(static_cast<double>(sum_unshot(state, c).magnitude), emitted);
  }
  return light;
}

Light read_twin(const DeviceScene& device, const Twin& twin) {
  Light light = empty_light(device);
  const double area_unit = 1 / (8 * device.grid.scale * device.grid.scale);
  const std::vector<glm::dvec3> radiosity = twin.element_radiosity(device.unit_watts, area_unit);
  const auto channels = static_cast<std::size_t>(device.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    const double emitted = twin.emitted(c);
    for (std::size_t e = 0; e < device.elements.size(); ++e) {
      light.radiosity[e * channels + c] = radiosity[e][static_cast<glm::length_t>(c)];
      light.received[e * channels + c] = part_of(twin.received(e, c), emitted);
      light.unshot[c] += part_of(std::abs(twin.unshot(e, c)), emitted);
    }
    light.escaped[c] = part_of(twin.escaped(c), emitted);
    light.back[c] = part_of(twin.back(c), emitted);
  }
  return light;
}

Light read_peer(const DeviceScene& device, const PeerSolution& peer) {
  Light light = empty_light(device);
  const peer::State& state = peer.state();
  const auto channels = static_cast<std::size_t>(device.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    const double emitted = static_cast<double>(state.emitted.c[c]);
    const std::vector<double> radiosity = peer.radiosities(static_cast<int>(c));
    for (std::size_t e = 0; e < device.elements.size(); ++e) {
      light.radiosity[e * channels + c] = radiosity[e];
      light.received[e * channels + c] =
          part_of(static_cast<double>(state.received[e * channels + c]), emitted);
    }
    light.escaped[c] = part_of(static_cast<double>(state.escaped.c[c]), emitted);
    light.back[c] = part_of(static_cast<double>(state.back.c[c]), emitted);
  }
  return light;
}

double imbalance_of(const Twin& twin) {
  double worst = 0;
  for (std::size_t c = 0; c < twin.scene().channels; ++c) {
    double left = twin.emitted(c) - twin.absorbed(c) - twin.escaped(c) - twin.back(c);
    for (std::size_t e = 0; e < twin.scene().element_count(); ++e) {
      left -= twin.unshot(e, c);
    }
    worst = std::max(worst, part_of(std::abs(left), twin.emitted(c)));
  }
  return worst;
}

}  // namespace fixrad::host

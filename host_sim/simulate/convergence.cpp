// SPDX-License-Identifier: MIT
#include "host_sim/simulate/convergence.h"

#include <algorithm>
#include <cmath>

namespace fixrad::host {
namespace {

double largest_reflectance(const Scene& scene, int c) {
  std::uint32_t largest = 0;
  for (std::uint16_t e = 0; e < scene.element_count; ++e) {
    largest = std::max(largest, scene.materials[scene.elements[e].material].reflectance[c]);
  }
  return std::ldexp(static_cast<double>(largest), -32);
}

}  // namespace

std::vector<ErrorBound> error_bounds(const State& state) {
  std::vector<ErrorBound> bounds;
  for (int c = 0; c < state.scene.channels; ++c) {
    ErrorBound bound = {static_cast<double>(sum_unshot(state, c).magnitude),
                        largest_reflectance(state.scene, c), 0};
    bound.flux = (bound.unshot + state.scene.element_count) / (1 - bound.largest_reflectance);
    bounds.push_back(bound);
  }
  return bounds;
}

std::vector<std::int32_t> received_flux_of(const State& state) {
  return {state.received, state.received + std::size_t{state.scene.element_count} * state.scene.channels};
}

FluxDistance flux_distance(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b, int c,
                           int channels) {
  FluxDistance sum = {0, 0};
  for (std::size_t i = static_cast<std::size_t>(c); i < a.size(); i += static_cast<std::size_t>(channels)) {
    sum.distance += std::abs(static_cast<double>(a[i]) - b[i]);
    sum.total += b[i];
  }
  return sum;
}

void shoot_on(State& state, Fraction stop) {
  state.settings.stop = stop;
  state.settings.overshoot = false;
  for (Radiosity& lent : state.sweep.ambient) {
    lent = Radiosity::from_raw(0);
  }
  while (shoot(state) == Status::ok) {
  }
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "tests/stability/bound_trial.h"

#include <algorithm>

#include "host_sim/simulate/convergence.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

// A moment of a solution: the bounds of each channel and what had been received.
struct Moment {
  std::vector<ErrorBound> bounds;
  std::vector<std::int32_t> received;
};

double use_of_bound(const Moment& moment, const std::vector<std::int32_t>& last) {
  double worst = 0;
  const int channels = static_cast<int>(moment.bounds.size());
  for (int c = 0; c < channels; ++c) {
    const double distance = flux_distance(moment.received, last, c, channels).distance;
    worst = std::max(worst, distance / moment.bounds[static_cast<std::size_t>(c)].flux);
  }
  return worst;
}

}  // namespace

std::vector<BoundScene> bound_scenes() {
  return {{"scenes/cornell.obj", cornell()},
          {"a cube of reflectance 0.95, one wall lit", cube(0.95, {1, 0, 0, 0, 0, 0})},
          {"a box on the floor of a room", room_with_box(Stand::closed_on_floor, 0.3)},
          {"a random closed room", random_closed_room(3)},
          {"a random open room", random_open_room(5)}};
}

BoundTrial try_bound(const Model& model, const SolveOptions& options) {
  Solution solution(model, options);
  State& state = solution.state();
  std::vector<Moment> moments;
  do {
    moments.push_back({error_bounds(state), received_flux_of(state)});
  } while (shoot(state) == Status::ok);
  shoot_on(state, fraction(1, 10000000));
  const std::vector<std::int32_t> last = received_flux_of(state);
  BoundTrial trial = {0, use_of_bound(moments.back(), last), static_cast<std::uint32_t>(moments.size())};
  for (const Moment& moment : moments) {
    trial.worst = std::max(trial.worst, use_of_bound(moment, last));
  }
  return trial;
}

}  // namespace fixrad::host

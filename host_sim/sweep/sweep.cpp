// SPDX-License-Identifier: MIT
#include "host_sim/sweep/sweep.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace fixrad::host {

SweepPoint solve_setting(const PreparedScene& scene, const Truth& truth, const BakeOptions& options,
                         const Progress& progress) {
  std::unique_ptr<WorkRecorder> recorder;
  const BakeResult result = bake(scene, options, progress, [&](const State& state) {
    recorder = std::make_unique<WorkRecorder>(state);
    return recorder->observer();
  });
  SweepPoint point;
  point.options = options;
  point.command = bake_options_text(options, result.plan);
  point.resolution = default_resolutions(options.engine).empty() ? 0 : result.plan.resolution;
  point.flux_per_row = flux_per_row(options, result.plan);
  point.flux_per_eye = flux_per_eye(options, result.plan);
  point.elements = result.plan.sizes.elements;
  point.patches = result.plan.meshing.patch_count;
  point.shots = result.shots;
  point.eyes = result.eyes;
  point.ram_bytes = result.plan.ram();
  point.pools = pool_bytes(result.plan.sizes) + result.plan.matrix_bytes;
  point.rom_bytes = result.device.rom_bytes();
  point.digest = result.digest;
  point.host_seconds = result.seconds;
  point.interrupted = result.interrupted;
  if (!point.interrupted) {
    const FaceMeanError error = error_against(truth, scene, result.device, result.element_radiosity);
    point.mean_error = error.mean;
    point.worst_error = error.worst;
    point.work = count_work(result, options, *recorder);
  }
  return point;
}

std::optional<double> cost_on(const CostModel& model, const SweepPoint& point) {
  return point.work && model.knows(point.options.engine) ? std::optional(cost(model, *point.work))
                                                         : std::nullopt;
}

std::vector<std::size_t> pareto_frontier(const std::vector<double>& cost, const std::vector<double>& error) {
  std::vector<std::size_t> order(cost.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(cost[a], error[a]) < std::make_pair(cost[b], error[b]);
  });
  std::vector<std::size_t> frontier;
  for (const std::size_t i : order) {
    if (std::isfinite(cost[i]) && (frontier.empty() || error[i] < error[frontier.back()])) {
      frontier.push_back(i);
    }
  }
  return frontier;
}

}  // namespace fixrad::host

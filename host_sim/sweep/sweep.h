// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "host_sim/sweep/cost_model.h"
#include "host_sim/sweep/setting.h"
#include "host_sim/sweep/truth.h"
#include "host_sim/sweep/work.h"

namespace fixrad::host {

/// One solved setting: a point of the plane of speed and error.
struct SweepPoint {
  BakeOptions options;
  std::string command;  ///< options of `fixrad bake` for it, without the scene
  int resolution = 0;   ///< 0 for an engine without
  double flux_per_row = 0, flux_per_eye = 0;
  std::uint32_t elements = 0, patches = 0, shots = 0, eyes = 0, ram_bytes = 0;
  std::uint32_t pools = 0;  ///< bytes of ram_bytes that are the same on every target
  std::size_t rom_bytes = 0;
  std::uint64_t digest = 0;
  double mean_error = 0;   ///< as FaceMeanError
  double worst_error = 0;  ///< as FaceMeanError
  double host_seconds = 0;
  std::optional<Work> work;  ///< nothing for an engine without a cost model
  bool interrupted = false;
};

/// Solves one setting and measures it. The result is the same on every machine and at every time but for
/// host_seconds. Throws InputError as bake().
SweepPoint solve_setting(const PreparedScene& scene, const Truth& truth, const BakeOptions& options,
                         const Progress& progress);

/// A point's cost on a target; nothing where the model does not know its engine.
std::optional<double> cost_on(const CostModel& model, const SweepPoint& point);

/// The Pareto frontier: indices of the points that no other point beats in both `cost` and `error`, by rising
/// cost and falling error. Of equal points the first counts. Costs that are not finite are left out.
std::vector<std::size_t> pareto_frontier(const std::vector<double>& cost, const std::vector<double>& error);

/// The points as CSV (RFC 4180 quoting, \n line ends): a header, a row a point in their order. Columns: the
/// setting, sizes, errors in per cent, host seconds, a column a target (`cortex_m0_instructions`), digest and
/// `command`, which starts with `tool` and names `scene`. Empty where there is no figure.
std::string sweep_csv(const std::vector<SweepPoint>& points, const std::string& command_start);

}  // namespace fixrad::host

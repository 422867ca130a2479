// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host_sim/cli/session.h"
#include "host_sim/reference/point_error.h"

namespace fixrad::host {

/// One way to tell the irradiance at a point from a solution, and how far it is from the truth.
struct PointLine {
  const char* name;
  const char* what;
  PointError error;
  double seconds;  ///< of the display step alone
};

/// The error of irradiance at points of surfaces.
struct PointBudget {
  std::size_t points = 0;
  std::vector<PointLine> lines;
  double truth_standard_error = 0;
  double truth_seconds = 0;
  std::size_t vertices = 0;  ///< displayed, all gathered
};

/// Compares `result` (of bake(), not displayed yet) at options.points points: flat elements, vertex colours
/// by the mean, by gathers at the corners of elements and at all displayed vertices, and a gather at each
/// point. options.points_truth: where the truth is read from if the file exists, else written to. Throws
/// InputError if that file is of another scene.
PointBudget measure_points(const LoadedScene& scene, const CommonOptions& options, const BakeResult& result);

/// As text on stdout, and for the .json.
void print(const PointBudget& budget);
nlohmann::ordered_json to_json(const PointBudget& budget);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/sweep/work.h"

namespace fixrad::host {

/// What a step costs on one target. Fitted to committed measurements by scripts/fit_costs.py.
struct CostModel {
  std::string target;                      ///< name of its CMake preset
  std::string unit;                        ///< "instructions" or "cycles"
  std::array<double, kWorkUnits> weights;  ///< unit a step, >= 0
  double residual;   ///< largest relative deviation from a measurement that the weights were fitted to
  int measurements;  ///< how many these were
  std::uint32_t pointer_bytes;
  std::vector<std::string> engines;  ///< that have been measured

  bool knows(const std::string& engine) const;
};

/// One a measured target, in the order of the presets.
const std::vector<CostModel>& cost_models();

/// The model of a target, if there is one.
const CostModel* find_cost_model(const std::string& target);

/// What `work` costs: instructions or cycles of the whole solution.
double cost(const CostModel& model, const Work& work);

}  // namespace fixrad::host

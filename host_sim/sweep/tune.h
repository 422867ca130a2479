// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "host_sim/sweep/sweep.h"

namespace fixrad::host {

/// What a solution on a target must keep to.
struct Wish {
  const CostModel* model = nullptr;
  std::uint32_t ram = 0;            ///< bytes that the solver may take on the target
  double max_error = 0.02;          ///< mean over faces against the truth, relative
  std::optional<double> max_worst;  ///< of faces with at least a tenth of the mean radiosity, relative
  std::optional<double> max_cost;   ///< instructions or cycles
};

/// What a search has found.
struct Tuned {
  std::optional<SweepPoint> cheapest;  ///< that keeps to the whole wish
  /// Where nothing does: the smallest error within the wished memory and cost, and the setting with the least
  /// memory (and where a cost was wished the least cost) that reaches the error; nothing if none does in the
  /// memory of the largest device profile.
  std::optional<SweepPoint> closest, enough;
  std::size_t solved = 0;
  bool interrupted = false;
};

/// Solves a setting; interrupted points end the search.
using Solve = std::function<SweepPoint(const BakeOptions&)>;

/// Bytes of a solver on the model's target, or, where that is more, on its profile's chip.
std::uint32_t ram_on(const CostModel& model, const BakePlan& plan);
std::uint32_t ram_on(const CostModel& model, const SweepPoint& point);

/// Looks for the cheapest setting that fulfils the wish: meshes in steps of 1.4 and numbers of rows, cheap
/// ones first and none that are likely to cost several times what was found; then rows, eye points and stop
/// fractions round the best. Deterministic. `base` gives what the search leaves alone. Cost: some hundred
/// solutions at most.
Tuned tune(const PreparedScene& scene, const Wish& wish, const BakeOptions& base, const Solve& solve);

}  // namespace fixrad::host

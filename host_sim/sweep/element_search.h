// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host_sim/sweep/tune.h"

namespace fixrad::host {

/// How many elements a wanted error takes.
struct ElementNeed {
  std::optional<SweepPoint> enough;   ///< the fewest that keep to the error; nothing if none does
  std::optional<SweepPoint> too_few;  ///< the largest mesh of that profile that was tried and does not
  std::optional<SweepPoint> closest;  ///< the least error of all that were tried
  bool interrupted = false;
};

/// Tries the profiles of devices in the order of their memory, each with meshes in steps of 1.4 and its own
/// choice of rows and eye points, until one keeps to `max_error` (mean over faces, relative) and so does the
/// next larger, since one mesh may be lucky; up to 6,000 elements. Cost: up to some fifty solutions.
ElementNeed find_elements(const PreparedScene& scene, double max_error, const BakeOptions& base,
                          const Solve& solve);

}  // namespace fixrad::host

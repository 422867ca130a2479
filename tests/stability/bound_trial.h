// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/lib/solution.h"

namespace fixrad::host {

/// A scene in which the error bound is watched.
struct BoundScene {
  std::string name;
  Model model;
};
std::vector<BoundScene> bound_scenes();

/// How the error bound fared over all moments of a solution, before each shot and in the end.
struct BoundTrial {
  double worst;  ///< largest distance to the converged solution over its bound, of any channel
  double last;   ///< the same where the solution stopped
  std::uint32_t moments;
};

/// Solves to options.settings.stop, and on until a ten-millionth is unshot: that is what distances are to.
BoundTrial try_bound(const Model& model, const SolveOptions& options);

}  // namespace fixrad::host

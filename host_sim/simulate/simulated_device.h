// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "lib/fixrad.h"

namespace fixrad::host {

/// A Solver whose capacities are known at run time only: the same State over heap arrays, so the same bits.
class SimulatedDevice {
 public:
  explicit SimulatedDevice(const Sizes& sizes);
  ~SimulatedDevice();
  SimulatedDevice(const SimulatedDevice&) = delete;
  SimulatedDevice& operator=(const SimulatedDevice&) = delete;

  /// As Solver::load.
  [[nodiscard]] Status load(const Scene& scene, const Settings& settings);

  State& state() { return state_; }
  const State& state() const { return state_; }

 private:
  struct Arrays;
  Sizes sizes_;
  std::unique_ptr<Arrays> arrays_;
  State state_ = {};
};

/// What each Status means to a person, and what to do about it.
const char* describe(Status status);

}  // namespace fixrad::host

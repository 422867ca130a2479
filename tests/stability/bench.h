// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/meshing/device_scene.h"
#include "host_sim/simulate/simulated_device.h"
#include "tests/stability/random_scene.h"

namespace fixrad::host {

/// The core's settings for a random scene.
Settings settings_of(const RandomScene& scene);

/// A random scene, or an image of it, meshed and loaded into a solver of just its size; not yet solved.
class Bench {
 public:
  /// `model`: of `scene`, perhaps shuffled or turned.
  Bench(Model model, const RandomScene& scene, const Settings& settings);
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  /// What load() said.
  Status status() const { return status_; }
  State& state() { return solver_.state(); }
  const DeviceScene& device() const { return device_; }

  /// Loads once more, after a change of device().
  Status load(const DeviceScene& device, const Settings& settings);

  /// Shoots until it has converged; false if that takes more than kMostShots shots or the core gives up.
  bool run();

  /// [element][channel], flux units.
  std::vector<std::int32_t> received() const;

  /// More than any random scene takes.
  static constexpr std::uint32_t kMostShots = 50000;

 private:
  Model model_;
  DeviceScene device_;
  SimulatedDevice solver_;
  Status status_;
};

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "host_sim/meshing/surface_mesh.h"
#include "host_sim/simulate/profile.h"
#include "host_sim/simulate/simulated_device.h"

namespace fixrad::host {

/// How a test wants a scene solved.
struct SolveOptions {
  std::uint32_t elements = 150;
  std::uint32_t patches = 0;  ///< 0: about one for four elements, as the tool makes them
  std::uint32_t spans = 0;    ///< 0: the documented 2 faces + 1
  Settings settings = {};
};

/// Hemicube rows with the one table of R for all shots, and the fraction at which shooting stops.
Settings settings_with(int resolution, Fraction stop);

/// Lune rows, the strongest shots with R, weaker ones with every smaller table, and the fraction at which
/// shooting stops.
Settings lune_settings(int resolution, Fraction stop);

/// The sizes that hold `device` exactly, with an item buffer where the settings need one.
Sizes sizes_for(const DeviceScene& device, std::uint32_t spans, const Settings& settings);

/// A model meshed, put on the device's grid and loaded into a simulated device; not yet solved. Fails the
/// current test if it does not load.
class Solution {
 public:
  /// `has_sights`: the scene knows which eyes are clear; otherwise the core probes them.
  Solution(Model model, const SolveOptions& options, bool has_sights = false);

  /// Shoots until the status is not ok; returns it.
  Status run();
  /// At most `shots` shots.
  Status run(int shots);

  State& state() { return solver_->state(); }
  const State& state() const { return solver_->state(); }
  const DeviceScene& device() const { return device_; }
  const PreparedScene& prepared() const { return prepared_; }

  /// Radiosity of an element, unit of the model's emission.
  double radiosity(std::uint32_t element, int channel = 0, bool with_ambient = false) const;
  /// Radiosity of all elements, one channel.
  std::vector<double> radiosities(int channel = 0, bool with_ambient = false) const;
  /// Area-weighted mean over each input face, one channel.
  std::vector<double> face_means(int channel = 0) const;
  /// Largest imbalance of any channel's ledger, flux units.
  std::int64_t imbalance() const;
  std::uint64_t digest() const;

 private:
  Model model_;
  PreparedScene prepared_;
  DeviceScene device_;
  std::unique_ptr<SimulatedDevice> solver_;
};

/// The eye point of an element.
EyePoint element_eye(const Scene& scene, std::uint32_t element, std::uint8_t turn = 0);

/// Largest and mean |a - b| over the mean of b.
struct Difference {
  double largest, mean;
};
Difference relative_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/meshing/device_scene.h"
#include "lib/transport/state.h"

namespace fixrad::host {

/// A solution as far as a law of physics can ask for it, whatever arithmetic it was made with.
struct Light {
  const DeviceScene* device;
  std::vector<double> received;                 ///< [element][channel], over all that the channel emits
  std::vector<double> radiosity;                ///< [element][channel], unit of the model's emission
  std::array<double, 3> escaped, back, unshot;  ///< [channel], over what the channel emits
};

/// What theory says about one number of a solution, and what the solution says.
struct Finding {
  std::string what;
  double value, expected;
  double bound;  ///< of |value - expected|; 0: no difference at all is allowed

  double error() const { return value < expected ? expected - value : value - expected; }
  bool holds() const { return error() <= bound; }
};

/// How a case is meshed and solved.
struct CaseSettings {
  std::uint32_t elements = 150;
  int lunes = 32;  ///< R of the strongest shots; the float peer has no more than 32
  Fraction stop = fraction(1, 10000);
  bool overshoot = false;
  Fraction flux_per_row = fraction(1, 10000);
  Fraction flux_per_eye = fraction(1, 10);
  std::vector<std::pair<int, int>> cells = {};  ///< of each face of the device, instead of `elements`
  bool spans_to_the_last = false;               ///< solve once more with just as many spans as were used
};

/// A scene that is hard for an arithmetic, and what theory knows of its light.
struct HardCase {
  std::string name;                ///< as a test's
  std::string hard;                ///< what is hard about it
  std::string theory;              ///< the expectation and where it comes from
  std::vector<Model> (*models)();  ///< one, or several whose solutions are to be compared
  CaseSettings settings;
  /// Findings from the light of all models, in their order.
  std::vector<Finding> (*judge)(const std::vector<Light>& lights);
};

/// All cases, in the order of docs/stability.md.
const std::vector<HardCase>& hard_cases();

/// The cases of one file each, in the order in which hard_cases() lists them.
std::vector<HardCase> furnace_cases();
std::vector<HardCase> lamp_cases();
std::vector<HardCase> shape_cases();
std::vector<HardCase> view_cases();
std::vector<HardCase> size_cases();

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/stability/random_scene.h"

namespace fixrad::host {

/// What every scene must keep to.
struct Property {
  std::string name;    ///< a claim, as a test's
  std::string theory;  ///< why it holds, and how exactly
  /// Empty if the scene keeps to it, or does not concern it; else what is wrong.
  std::function<std::string(const RandomScene&)> check;
};

/// All properties, the cheapest first.
const std::vector<Property>& properties();

/// A scene that does not keep to a property, as small as it could be made, and what is wrong with it.
struct Failure {
  RandomScene scene;
  std::string reason;
  std::uint32_t steps;  ///< of simplification
};

/// Makes a failing scene simpler, step by step, as long as it fails.
Failure shrink(const RandomScene& failing, const Property& property);

/// The failure for a person: what is wrong, how to run it again, and the scene as OBJ and MTL.
std::string report(const Failure& failure, const Property& property);

/// Checks the scenes of the seeds first .. first + count - 1; returns the shrunk failures, at most `most` of
/// them. `progress` hears the number of scenes done.
std::vector<Failure> check_scenes(const Property& property, std::uint64_t first, std::uint64_t count,
                                  std::size_t most, const std::function<void(std::uint64_t)>& progress = {});

}  // namespace fixrad::host

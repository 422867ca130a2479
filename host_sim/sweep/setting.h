// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/bake/bake.h"

namespace fixrad::host {

/// Values that a sweep combines, each with each; an empty list of resolutions or element counts leaves the
/// choice to the profile.
struct Choices {
  std::vector<std::string> profiles;
  std::vector<std::string> engines;
  std::vector<int> resolutions;
  std::vector<double> flux_per_eye;
  std::vector<std::uint32_t> elements;
};

/// The engines that a sweep compares, the default one first.
const std::vector<std::string>& swept_engines();

/// Every combination of `choices` on top of `base`, without combinations that make_plan() would turn into one
/// solution: the same plan from several numbers of elements counts once. Combinations that do not fit their
/// profile's memory are left out. Cost: a search for a mesh a profile,
/// engine and number of elements.
std::vector<BakeOptions> all_settings(const PreparedScene& scene, const BakeOptions& base,
                                      const Choices& choices);

/// The options of `fixrad bake` that lead to this solution and no other, without the scene.
std::string bake_options_text(const BakeOptions& options, const BakePlan& plan);

/// `word` as one word of a POSIX shell: in single quotes unless it is plain.
std::string shell_word(const std::string& word);

}  // namespace fixrad::host

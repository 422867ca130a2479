// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/bake/bake.h"

namespace fixrad::host {

/// Values that a sweep combines, each with each. Empty lists: resolutions that suit each engine
/// (default_resolutions()), flux_per_row at multiples of the profile's own (default_row_factors()), the
/// profile's choice of flux_per_eye and elements.
struct Choices {
  std::vector<std::string> profiles;
  std::vector<std::string> engines;
  std::vector<int> resolutions;
  std::vector<double> flux_per_row;
  std::vector<double> flux_per_eye;
  std::vector<std::uint32_t> elements;
  bool leaves_out_slow = false;  ///< rays on more than 1,000 elements: their cost is quadratic
};

/// The engines that a sweep compares, the default one first.
const std::vector<std::string>& swept_engines();

/// R that a sweep takes for an engine; for lunes the finest that strong shots reach. Empty: it has none.
const std::vector<int>& default_resolutions(const std::string& engine);

/// Multiples of the profile's flux_per_row: a factor of two apart for lunes, whose rows it counts; two for
/// the other engines, where it only decides which elements shoot together.
const std::vector<double>& default_row_factors(const std::string& engine);

/// The flux_per_row, or flux_per_eye, of these options on this plan.
double flux_per_row(const BakeOptions& options, const BakePlan& plan);
double flux_per_eye(const BakeOptions& options, const BakePlan& plan);

/// `value` to three digits, so that commands are short and still mean exactly the same number.
double short_value(double value);

/// Every combination of `choices` on top of `base`, without combinations that make_plan() would turn into one
/// solution: the same plan from several numbers of elements counts once. Left out are combinations that do
/// not fit their profile's memory, resolutions that an engine does not have, and contours where faces may
/// hide each other. Cost: a search for a mesh a profile, engine and number of elements.
std::vector<BakeOptions> all_settings(const PreparedScene& scene, const BakeOptions& base,
                                      const Choices& choices);

/// The options of `fixrad bake` that lead to this solution and no other, without the scene.
std::string bake_options_text(const BakeOptions& options, const BakePlan& plan);

/// `word` as one word of a POSIX shell: in single quotes unless it is plain.
std::string shell_word(const std::string& word);

}  // namespace fixrad::host

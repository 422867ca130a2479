// SPDX-License-Identifier: MIT
// What `info` prints and writes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/cli/session.h"
#include "host_sim/sweep/element_search.h"
#include "host_sim/sweep/needs.h"

namespace fixrad::host {

/// What the user wants of `info`.
struct InfoOptions {
  std::string target;  ///< whose instructions are counted; empty: the profile's chip
  std::optional<double> max_error_percent;
};

/// A search for the elements of a wanted error, and what it was measured against.
struct WantedError {
  double max_error = 0;             ///< relative
  double truth_standard_error = 0;  ///< relative
  ElementNeed need;
};

/// One line of the table of profiles.
struct ProfileCost {
  Profile profile;
  std::optional<BakePlan> plan;  ///< nothing where the scene does not fit
  std::size_t rom_bytes = 0;
};

/// Everything on the page.
struct InfoPage {
  const LoadedScene* scene = nullptr;
  const CommonOptions* options = nullptr;
  const CostModel* model = nullptr;
  SceneNeeds needs;
  std::optional<WantedError> wanted;
  std::vector<ProfileCost> profiles;
};

/// The page: what the scene needs, what is left out, elements for a wanted error, memory by profile, in
/// blocks with an empty line between them; the memory comes last.
std::string info_text(const InfoPage& page);

/// The same figures.
nlohmann::ordered_json info_json(const InfoPage& page);

/// Subcommand `info`; returns an ExitCode and throws InputError.
void add_info_options(CLI::App& command, CommonOptions& options, InfoOptions& info);
int run_info(const CommonOptions& options, const InfoOptions& info);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host_sim/cli/showcase.h"

namespace fixrad::host {

/// The page of a sweep: HTML in one file that asks nothing of any network. The same bytes for the same input.
/// Throws InputError if the tool was built without its page.
std::string sweep_page(const CommonOptions& options, const std::string& command_start, const Truth& truth,
                       const std::vector<SweepPoint>& points, const Showcase& showcase);

}  // namespace fixrad::host

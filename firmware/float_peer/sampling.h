// SPDX-License-Identifier: MIT
#pragma once

#include "firmware/float_peer/state.h"

namespace fixrad {
namespace peer {

/// Fills state.row with the form factors of `source` for a shot of `flux` (sum over channels): the core's
/// rules for the number of rows and eye points, their positions (lib/elements) and order of turns.
/// Returns ok, or span_pool_full with the row unusable.
Status sample_source(State& state, const EyeSource& source, float flux);

}  // namespace peer
}  // namespace fixrad

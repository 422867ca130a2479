// SPDX-License-Identifier: MIT
#pragma once

#include "firmware/float_peer/state.h"

namespace fixrad {
namespace peer {

/// Fills state.row with the form factors of `source`, seen from as many balanced eye points as `wanted` asks
/// for: the core's rules, positions (lib/elements) and order of turns; weights in float.
/// Returns ok, or span_pool_full with the row unusable.
Status sample_source(State& state, const EyeSource& source, uint16_t wanted, KnownEyes& known);

}  // namespace peer
}  // namespace fixrad

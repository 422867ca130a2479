// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

/// Fills state.row with the form factors of `source`, seen from as many balanced eye points as `wanted` asks
/// for. Each eye's share follows the flux of the element that it stands for; buried eyes (more than half of
/// what they see shows its back) are withdrawn and replaced by finer ones. `known` remembers what was
/// found out. Returns ok, or span_pool_full with the row unusable.
Status sample_source(State& state, const EyeSource& source, uint32_t wanted, KnownEyes& known);

}  // namespace fixrad

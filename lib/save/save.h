// SPDX-License-Identifier: MIT
#pragma once

#include "lib/save/identity.h"
#include "lib/save/saved_state.h"

namespace fixrad {

/// Writes the state of a solution by shooting, as it is between two shots (one that is under way will begin
/// anew), into `sink`: saved_bytes() of bytes. `sequence` is the caller's number for it, see slots.h.
/// Statuses: ok, write_failed, refined. Cost: two surveys of the elements, and linear.
SaveStatus save_state(const State& state, const Identity& identity, const StateSink& sink, uint32_t sequence);

}  // namespace fixrad

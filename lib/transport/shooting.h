// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

/// One shot of progressive refinement (Cohen et al. 1988; Southwell relaxation): the patch with the most
/// unshot flux sends it out. Returns ok, converged (nothing done: the sum of unshot flux is at most
/// settings.stop of the emitted flux in every channel), or span_pool_full (state unchanged but for the
/// counters of eyes). Cost: bounded; one row of form factors an eye point, then two wide products an
/// element and channel (for a small share one, and three of 32 bits).
Status shoot(State& state);

/// Unshot flux over emitted flux in the worst channel, UQ0.32, saturated just below 1.
Fraction unshot_fraction(const State& state);

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

/// One shot of progressive refinement (Cohen et al. 1988; Southwell relaxation): the patch with the most
/// unshot flux sends it out. Returns ok, converged (nothing done: the sum of unshot flux is at most
/// settings.stop of the emitted flux in every channel), or span_pool_full (state unchanged but for the
/// counters of eyes). Cost: bounded; one row of form factors an eye point, then two products an element and
/// channel.
Status shoot(State& state);

/// Flux a shot of `amount` leaves with each receiver, cut from running sums so that the parts add up to the
/// whole; sums in units of 1/kRowOne. Borders are rounded down after adding `phase` (0 .. kRowOne - 1), which
/// differs from shot to shot: a fixed phase would give the odd unit of every small shot to the same elements.
/// Odd in `amount`.
Flux share_of(Flux amount, uint32_t sum_before, uint32_t sum_after, uint32_t phase);

/// Unshot flux over emitted flux in the worst channel, UQ0.32, saturated just below 1.
Fraction unshot_fraction(const State& state);

}  // namespace fixrad

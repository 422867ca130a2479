// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

/// One shot of progressive refinement (Cohen et al. 1988; Southwell relaxation): first each emitting element
/// sends what it emits; then the sources with most unshot flux send it out, elements, later patches, in the
/// end faces, each that holds at least 11/16 of the most that one had when the pass began. Goes on with a
/// shot that is under way. Returns ok, converged (nothing done: a pass ended with the sum of unshot flux at
/// most settings.stop of the emitted flux in every channel), or span_pool_full (solution unchanged). Cost:
/// bounded, see docs/bounded_time.md; one row of form factors an eye point, then two 32-bit products an
/// element and channel (for a large share one wide one; from faces three more); and a survey of all elements'
/// unshot flux where a pass begins.
Status shoot(State& state);

/// The same, but does at most `budget` units of work (at least 1; what a unit is says view.h, what it costs
/// docs/bounded_time.md) and returns in_progress where the shot is not complete yet. Whatever the budgets,
/// the shots are the same to the bit. Until a shot is complete nothing of it is booked: `received`,
/// `accounts`, the ledger, counters and the next turn are those before it, and can be read or saved at any
/// time; row, work and sampling are scratch memory. A pass may have begun, which changes `sweep` and no
/// light. Before scene, settings or light are changed from outside, abandon_shot().
Status shoot_for(State& state, uint32_t budget);

/// Gives up a shot that is under way, at any time: the next call begins it anew, to the same bits.
void abandon_shot(State& state);

/// Unshot flux over emitted flux in the worst channel, UQ0.32, saturated just below 1.
Fraction unshot_fraction(const State& state);

}  // namespace fixrad

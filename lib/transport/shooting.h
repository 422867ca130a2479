// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

/// One shot of progressive refinement (Cohen et al. 1988; Southwell relaxation): first each emitting element
/// sends what it emits; then the sources with most unshot flux send it out, elements, later patches, in the
/// end faces, each that holds at least 11/16 of the most that one had when the pass began. Returns ok,
/// converged (nothing done: a pass ended with the sum of unshot flux at most settings.stop of the emitted
/// flux in every channel), or span_pool_full (state unchanged but for the counters of eyes). Cost: bounded;
/// one row of form factors an eye point, then two 32-bit products an element and channel (for a large share
/// one wide one; from faces three more); and a survey of all elements' unshot flux where a pass begins.
Status shoot(State& state);

/// Unshot flux over emitted flux in the worst channel, UQ0.32, saturated just below 1.
Fraction unshot_fraction(const State& state);

}  // namespace fixrad

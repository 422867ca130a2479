// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

/// Begins to fill state.row with the form factors of `source`, for a shot of `flux` (sum over channels): one
/// row of samples for each part settings.flux_per_row of the emitted flux, in one view from an element, from
/// few points of a patch or face, where they have reflected most. Eyes that are buried are left out; where
/// all are, and no light can escape, the light stays where it is.
void begin_source(State& state, const EyeSource& source, uint64_t flux);

/// Goes on with it, with the same source. Returns ok (state.sampling is complete), in_progress
/// (state.work.budget is used up), or span_pool_full (nothing is under way any more).
Status go_on_with_source(State& state, const EyeSource& source);

/// Counts the eyes of the row that is complete, and takes it that nothing is under way.
void book_eyes(State& state);

/// Fills state.row with the form factors of one element with at least `eyes` eye points (as far as
/// kFinestLevel allows) and `rows` rows in all, without a limit; gives up a shot that is under way.
Status sample_element(State& state, uint16_t element, uint32_t eyes, uint32_t rows);

}  // namespace fixrad

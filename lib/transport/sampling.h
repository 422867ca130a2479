// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

/// Fills state.row with the form factors of `source`, for a shot of `flux` (sum over channels): one row of
/// samples for each part settings.flux_per_row of the emitted flux, in one view from an element, from few
/// points of a patch or face, where they have reflected most. Eyes that are buried are left out; where all
/// are, and no light can escape, the light stays where it is. Returns ok or span_pool_full.
Status sample_source(State& state, const EyeSource& source, uint64_t flux);

/// The same for one element with at least `eyes` eye points (as far as kFinestLevel allows) and `rows` rows
/// in all.
Status sample_element(State& state, uint16_t element, uint32_t eyes, uint32_t rows);

}  // namespace fixrad

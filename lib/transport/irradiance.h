// SPDX-License-Identifier: MIT
#pragma once

#include "lib/form_factor/direct_light.h"
#include "lib/transport/state.h"

namespace fixrad {

/// What arrives at a point from the hemisphere over it.
struct Irradiance {
  Radiosity of[kMaxChannels];  ///< the scene's radiosity unit
  uint32_t seen;               ///< UQ1.20, part of the hemisphere (cosine-weighted) in which fronts are seen
};

/// Gathers at `eye` what all elements send now (Cohen & Wallace 1993, section 10.3.2, with the solver's own
/// hemisphere): the sum of F_j B_j, F_j sampled by the solver's engine with `table`, B_j with `ambient`
/// [channels] added; `direct` corrects the entries of lamps, null leaves them as sampled. A fraction below
/// kRowOne of `seen` faces backs or nothing; there it is dark. Uses the row of form factors and the views as
/// scratch memory, so a shot that is under way is given up and begins anew at the next step: gather between
/// shots, or seldom. `is_clear`: the eye is known to stand in nothing.
/// Statuses: ok, span_pool_full. Cost: one view, and a 64-bit division for each channel of each element seen.
Status gather_irradiance(State& state, const DeltaTable& table, DirectLight direct, const EyePoint& eye,
                         bool is_clear, const Radiosity* ambient, Irradiance& irradiance);

}  // namespace fixrad

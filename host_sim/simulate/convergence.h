// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "lib/fixrad.h"

namespace fixrad::host {

/// The error bound that comes for free with the ledger, one channel: how far what all elements have received
/// is from what they will have received in the end, summed over the elements, flux units.
///
/// Without overshooting it is proven, whatever the rows of form factors are, sampled or exact: from here on
/// an element absorbs more than (1 - reflectance) x (what it still receives) - 1, and all of them together no
/// more than what is unshot. It is a bound of the total flux, so also of every single element's; the
/// radiosity of a small element may be further off. After overshooting, where unshot flux has either sign, it
/// holds for fixed form factors in exact arithmetic; with sampled ones it is measured (docs/stability.md).
struct ErrorBound {
  double unshot;               ///< sum of |unshot|
  double largest_reflectance;  ///< of the scene's elements
  double flux;                 ///< (unshot + one unit an element) / (1 - largest_reflectance)
};

/// Of each channel of the scene. Cost: linear.
std::vector<ErrorBound> error_bounds(const State& state);

/// What each element has received, [element][channel], flux units.
std::vector<std::int32_t> received_flux_of(const State& state);

/// Sum over the elements of |a - b| and of b, channel `c` of `channels`.
struct FluxDistance {
  double distance, total;
};
FluxDistance flux_distance(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b, int c,
                           int channels);

/// Shoots on, without overshooting, until no more than `stop` of the emitted flux is unshot.
void shoot_on(State& state, Fraction stop);

}  // namespace fixrad::host

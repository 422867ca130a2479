// SPDX-License-Identifier: MIT
#pragma once

#include "firmware/float_peer/state.h"

namespace fixrad {
namespace peer {

/// One shot of progressive refinement, of the source that the core's rules choose: emission first, then
/// sweeps over elements, patches, faces. Returns ok, converged (nothing done), or span_pool_full. A stop
/// below 1e-6 of the emitted flux is below the rounding of sums in float. Cost: as the core's; a product and
/// a sum an element and channel, two of each once faces shoot.
Status shoot(State& state);

}  // namespace peer
}  // namespace fixrad

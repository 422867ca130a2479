// SPDX-License-Identifier: MIT
#pragma once

#include "firmware/float_peer/state.h"

namespace fixrad {
namespace peer {

/// One shot of progressive refinement: the patch with the most unshot flux sends it out. Returns ok,
/// converged (nothing done), or span_pool_full. Cost: as the core's; two products an element and channel.
Status shoot(State& state);

}  // namespace peer
}  // namespace fixrad

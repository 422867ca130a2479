// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/reference/twin.h"
#include "tests/float_peer/peer_solution.h"
#include "tests/stability/hard_case.h"

namespace fixrad::host {

// The three arithmetics' solutions in common terms. `device` is the scene that they are of, and must outlive
// the Light.

Light read_core(const DeviceScene& device, const State& state);
Light read_twin(const DeviceScene& device, const Twin& twin);
Light read_peer(const DeviceScene& device, const PeerSolution& peer);

/// emitted - absorbed - unshot - escaped - back of a twin, over emitted, the largest of all channels.
double imbalance_of(const Twin& twin);

}  // namespace fixrad::host

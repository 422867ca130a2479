// SPDX-License-Identifier: MIT
#pragma once

#include "tests/lib/solution.h"

namespace fixrad::host {

/// Solves by gathering: fills the matrix, sweeps until nothing moves (at most 5000 times) and books the
/// result. Fails the current test if a row cannot be sampled or the sweeps do not end. Returns the number of
/// sweeps.
int gather(Solution& solution);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/transport/state.h"

namespace fixrad {

/// What a saved state belongs to. Equal on every target, and whatever room the solver has.
struct Identity {
  uint64_t scene;     ///< FNV-1a of every number of the scene's tables that the solver reads
  uint64_t settings;  ///< of the settings' numbers, and of what engine, tables and near field compute
  uint16_t elements;  ///< of the scene when it was identified
};

/// Raised whenever the same scene and settings come to other bits than before.
constexpr uint32_t kBitsRevision = 1;

/// Identifies what has been loaded. Functions have no name that is the same everywhere, and comparing them
/// with the core's own would link all of these, so an engine is known by what it does: the rows of form
/// factors of four eyes, with each table in turn, corrected by the near field. Engines that agree in all of
/// them are taken for the same. Right after load(), or before elements are split; uses the row of form
/// factors and the views as scratch memory, so a shot that is under way is given up and begins anew at the
/// next step. Changes nothing else. Cost: four
/// eyes, a probe, and four 64-bit products for each number in the scene's tables.
Identity identify(State& state);

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include "lib/save/identity.h"
#include "lib/save/saved_state.h"

namespace fixrad {

/// Reads the beginning of a saved state, whatever scene it is of, once its magic, length and checksum are
/// right. Statuses: ok, not_a_state, truncated, damaged, older_version, newer_version, inconsistent (channels
/// and counts do not give the length); `header` is to be read if ok. Cost: one reading of the source.
SaveStatus read_header(const StateSource& source, SavedHeader& header);

/// Whether a solver in `state` can go on from what `source` gives: as read_header(), and also foreign_scene,
/// foreign_settings, inconsistent. Nothing of a saved state is believed: every number is in its range, and
/// what elements and faces hold adds up to the ledger, exactly. Without overshooting no part of the ledger is
/// below 0, from which it follows that no flux to come overflows (docs/numbers.md). Cost: two readings, and a
/// survey.
SaveStatus check_saved(const State& state, const Identity& identity, const StateSource& source,
                       SavedHeader& header);

/// Goes on from a saved state: `state` has been loaded with its scene and settings, and is between two shots
/// or at its beginning. Statuses as check_saved(); everything but ok leaves `state` as it was. One exception:
/// a source that gives other bytes when they are read once more, after they have been checked, is `damaged`,
/// and the solution starts anew. Cost: three readings.
SaveStatus load_state(State& state, const Identity& identity, const StateSource& source);

}  // namespace fixrad

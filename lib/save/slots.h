// SPDX-License-Identifier: MIT
#pragma once

#include "lib/save/resume.h"

namespace fixrad {

// Two places for saved states, written in turn: while one is being written the other holds the state before,
// so that power may be lost at any byte.
//
//     SlotChoice slots = choose_slot(state, identity, sources);      // after load()
//     if (slots.newest != kNoSlot) {
//       status = load_state(state, identity, sources[slots.newest]);
//     }
//     ...
//     save_state(state, identity, sinks[slots.next], slots.sequence); // whenever a shot is worth it
//     slots = after_saving(slots);

constexpr uint8_t kNoSlot = 2;

struct SlotChoice {
  uint8_t newest;     ///< 0 or 1, the one to resume from; kNoSlot: no slot holds a state of this solver
  uint8_t next;       ///< 0 or 1, the one to write next
  uint32_t sequence;  ///< for save_state()
};

/// Which of two slots holds the newest state of this solver: of those that check_saved() takes, the one with
/// the higher sequence, round the end of 32 bits. A slot that is refused, whatever it holds, is the next to
/// be written. Cost: check_saved() twice.
SlotChoice choose_slot(const State& state, const Identity& identity, const StateSource (&slots)[2]);

/// The choice once `choice.next` has been written completely; without reading anything.
FIXRAD_MODULO inline SlotChoice after_saving(const SlotChoice& choice) {
  return {choice.next, static_cast<uint8_t>(1 - choice.next), choice.sequence + 1};
}

}  // namespace fixrad

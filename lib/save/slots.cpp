// SPDX-License-Identifier: MIT
#include "lib/save/slots.h"

namespace fixrad {
namespace {

// Not inlined: one header on the stack at a time.
__attribute__((noinline)) bool sequence_in(const State& state, const Identity& identity,
                                           const StateSource& slot, uint32_t& sequence) {
  SavedHeader header;
  const bool is_ours = check_saved(state, identity, slot, header) == SaveStatus::ok;
  sequence = is_ours ? header.sequence : 0;
  return is_ours;
}

}  // namespace

FIXRAD_MODULO SlotChoice choose_slot(const State& state, const Identity& identity,
                                     const StateSource (&slots)[2]) {
  uint32_t sequence[2] = {0, 0};
  const bool has_first = sequence_in(state, identity, slots[0], sequence[0]);
  const bool has_second = sequence_in(state, identity, slots[1], sequence[1]);
  const uint32_t ahead = sequence[1] - sequence[0];
  const bool is_second = has_second && (!has_first || (ahead != 0 && ahead < 0x80000000u));
  SlotChoice choice =
      after_saving({kNoSlot, static_cast<uint8_t>(is_second ? 1 : 0), sequence[is_second ? 1 : 0]});
  if (!has_first && !has_second) {
    choice.newest = kNoSlot;
  }
  return choice;
}

}  // namespace fixrad

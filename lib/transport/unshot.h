// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

// Who has still to send how much. While elements and patches shoot, each element's account holds what it has
// sent on of what it reflects, as a short flux: 2 bytes a channel, and its unshot flux is
// reflect(received) - sent, so nothing is rounded away. Once only faces shoot, the same memory holds the
// unshot flux of each face, to the unit. What emitters have not sent yet stands in neither:
// State::next_emitter tells.

/// Words of accounts a channel: one for two elements, or one a face.
constexpr uint32_t account_words(uint32_t elements, uint32_t faces) {
  return elements > 2 * faces ? (elements + 1) / 2 : faces;
}

/// What element `e` has sent on of what it has received. Needs sweep.kind != face.
uint32_t sent_flux(const State& state, uint16_t e, int c);

/// The same as it is kept, a short flux. Needs sweep.kind != face.
void set_sent(State& state, uint16_t e, int c, uint16_t sent);

/// Unshot flux of face `face`. Needs sweep.kind == face.
Flux face_unshot(const State& state, uint16_t face, int c);
void set_face_unshot(State& state, uint16_t face, int c, Flux unshot);

/// Unshot flux of a source of the kind that shoots now, one a channel; returns flux_meant() of the
/// magnitudes.
uint64_t unshot_of(const State& state, const EyeSource& source, Flux* unshot);

/// What `source` can send now: its unshot flux, where its account can hold the sum that it has sent, and what
/// the pass lends it, never more than its unshot flux (larger loans were seen to diverge). amount [channels].
/// Returns whether there is anything.
bool plan_amount(const State& state, const EyeSource& source, Flux* amount);

/// Books that `source` sends what plan_amount() says, and says it too.
void book_sent(State& state, const EyeSource& source, Flux* amount);

/// From now on faces shoot. Uses the row of form factors as scratch memory.
void group_by_face(State& state);

/// The same from empty accounts, with all emission sent.
void start_face_accounts(State& state);

/// Adds to what face `face` has to send. Needs sweep.kind == face.
void account_unshot(State& state, uint16_t face, int c, Flux more);

/// Puts an element's share of what `parent` has received and sent, channel by channel, into a new element
/// parent + 1, of which those behind it make room: `weight` of weight + `rest` is the parent's part. The
/// scene already counts the new element. Sums stay as they are, to the unit. Needs sweep.kind != face.
void share_flux(State& state, uint16_t parent, const uint32_t* weight, const uint32_t* rest);

/// What the sources of the kind that shoots now have to send.
struct Survey {
  uint64_t most;                     ///< that one of them has, flux_meant() of the magnitudes
  uint64_t magnitude[kMaxChannels];  ///< sum of |unshot| over elements, later over faces
  int64_t balance[kMaxChannels];     ///< sum of unshot
};
Survey survey_unshot(const State& state);

/// Sum of |unshot| and of unshot over the shooters, channel `c`: over elements, later over faces; emission
/// included.
struct UnshotSum {
  uint64_t magnitude;
  int64_t balance;
};
UnshotSum sum_unshot(const State& state, int c);

}  // namespace fixrad

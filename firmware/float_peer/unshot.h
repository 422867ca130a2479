// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/state.h"

namespace fixrad {
namespace peer {

// Who has still to send how much. While elements and patches shoot, accounts [element][channel] hold what
// each element has sent on of what it reflects; its unshot flux is the rest. Once faces shoot, accounts
// [face][channel] in the same memory hold the unshot flux of each face; every face has an element, so there
// is room. What emitters have not sent yet stands in neither: State::next_emitter tells.

/// Reflectances of elements that come one after the other: converted where the material changes.
class Reflectances {
 public:
  explicit Reflectances(const Scene& scene) : scene_(scene) {}

  const Channels& of(uint16_t element) {
    const uint16_t material = flash_at(scene_.elements, element).material;
    if (material != material_) {
      material_ = material;
      reflectance_ = reflectance_of(scene_, material);
    }
    return reflectance_;
  }

 private:
  const Scene& scene_;
  uint16_t material_ = 0xffff;
  Channels reflectance_ = {};
};

/// The source at sweep.cursor, of the kind that shoots now.
EyeSource source_at_cursor(const State& state);
bool has_source(const State& state);
void advance(State& state, const EyeSource& source);

/// Unshot flux of a source of the kind that shoots now. Cost: a product and a difference a channel of each
/// element; of a face none.
Channels unshot_of(const State& state, const EyeSource& source, Reflectances& reflectances);

/// Sum of the magnitudes of all channels in use.
float magnitude_of(const State& state, const Channels& flux);

/// What `source` sends now: its unshot flux and what the pass lends it, never more than its unshot flux.
Channels amount_of(const State& state, const EyeSource& source);

/// Books that `source` sends amount_of() it.
void book_sent(State& state, const EyeSource& source);

/// From now on faces shoot.
void group_by_face(State& state);

/// All that is unshot once emitters have sent what they emit, in one scan of the sources of the kind that
/// shoots now.
struct UnshotScan {
  float loudest;       ///< the most that a source has, sum over channels
  Channels magnitude;  ///< sums of |unshot| over elements, later over faces
  Channels balance;    ///< of unshot
};
UnshotScan scan_unshot(State& state);

}  // namespace peer
}  // namespace fixrad

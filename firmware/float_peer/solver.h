// SPDX-License-Identifier: MIT
#pragma once

// The float peer: the core's algorithm as one would write it in `float`, to be measured beside it on the same
// processor. It is a yardstick, not a product.
//
// The same as in the core: the scene's tables in flash; who shoots when: emission, then sweeps over elements,
// patches and faces; rows and eye points by flux, their order and turns; sights and the probe for buried
// eyes; lune rows of the same resolutions with ends anywhere along the row; visibility between faces by
// 1/depth; the element grid; overshooting, stop rule; vertex radiosity.
// Which rows a vertex is above is found once an eye. What is sampled is the same, so shots and eyes are about
// the same; near ties fall differently.
//
// What differs is what float makes natural, and cheap where every operation is a call:
//
// Flux, form factors, positions and planes are `float`. Parts need not be cut from running sums, and the
// ledger balances within rounding only. What an element has sent is a float too, so nothing of it is kept
// back.
//
// A float has range enough for the plane in front of the eye: lunes are lines of that plane, positions are x
// itself, not folded, and everything on a row is linear in x. A vertex in front of the eye has an image on
// the plane (one division). An edge between two images is a line: its crossing costs one product a row and no
// division. Which edges cross is asked anew only where a vertex of the face is passed.
//
// 1/depth is one linear function a face, scaled by its height: differences of it are compared without further
// products, and it is the denominator of the cell coordinates too. A reciprocal at each end of a visible
// interval tells how many element borders lie between; each then costs one division.
//
// The running sum along a lune is a table of straight lines; exponent and first bits of a position say which.
// Samples are not scaled at all, as the eyes of a shot are equally strong: a row of form factors knows what
// its whole is. A material is converted once for each run of elements that share it.
//
// Integers only where they count or compare rows, and for the offset of a vertex from the eye before it
// becomes a float. Only <stdint.h>; no double, no library function but the compiler's own arithmetic.

#include "firmware/float_peer/shooting.h"

namespace fixrad {
namespace peer {

/// As fixrad::Solver, with the same limits (fixrad::Limits); lune_rows only. Not to be copied or moved.
template <class L>
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// Checks `scene` with the core's check_scene() and starts its solution; anything but ok leaves the solver
  /// as it was. item_buffer_too_small: another engine, or a resolution that the peer has no lunes for (R is
  /// 4, 8, 16 or 32).
  [[nodiscard]] Status load(const Scene& scene, const Settings& settings = {}) {
    Status status = check_scene(scene, {L::vertices, L::faces, L::elements, L::channels});
    if (status == Status::ok && (settings.engine != fixrad::lune_rows || !has_tables(settings))) {
      status = Status::item_buffer_too_small;
    }
    if (status == Status::ok) {
      state_.work = {vertices_, views_, spans_, L::spans, 0};
      state_.row = {share_, scene.element_count, 0.0f, 0.0f, 0.0f};
      state_.received = received_;
      state_.accounts = accounts_;
      reset(state_, scene, settings);
    }
    return status;
  }

  /// One shot; see shoot().
  [[nodiscard]] Status step() { return shoot(state_); }

  /// Radiosity of an element or at a vertex, in the unit of the core's Radiosity.
  float element_radiosity(uint16_t element, uint8_t channel) const {
    return peer::element_radiosity(state_, element, channel);
  }
  float vertex_radiosity(const VertexMap& map, uint32_t vertex, uint8_t channel) const {
    return peer::vertex_radiosity(state_, map, vertex, channel);
  }

  uint32_t shots() const { return state_.shots; }
  uint32_t eyes() const { return state_.eyes; }

  State& state() { return state_; }
  const State& state() const { return state_; }

 private:
  static bool has_tables(const Settings& settings) {
    const unsigned coarsest = flash_at(settings.tables, 0).resolution_log2;
    return has_lunes(coarsest) && has_lunes(coarsest + settings.table_count - 1u) &&
           has_lunes(flash_at(settings.probe, 0).resolution_log2);
  }

  State state_;
  float received_[static_cast<uint32_t>(L::elements) * L::channels];
  float accounts_[static_cast<uint32_t>(L::elements) * L::channels];
  FaceView views_[L::faces];
  VertexView vertices_[L::vertices];
  Span spans_[L::spans];
  float share_[L::elements];
};

}  // namespace peer
}  // namespace fixrad

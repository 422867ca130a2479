// SPDX-License-Identifier: MIT
#pragma once

// clang-format off
// Radiosity in fixed point, one page:
//
//     static fixrad::Solver<fixrad::Limits<28, 20, 264>> solver;  // all memory there is
//
//     fixrad::Status status = solver.load(scene);            // checks everything or changes nothing
//     while (status == fixrad::Status::ok) {
//       status = solver.step();                              // the brightest shoot first
//     }                                                      // step(budget): in slices, for a main loop
//     colour = solver.vertex_radiosity(map, vertex, channel);  // any time: the picture only gets better
//
// Integers only, no heap, no exceptions; the same bits on every processor.
// clang-format on

#include "lib/refine/refinement.h"
#include "lib/save/resume.h"
#include "lib/save/save.h"
#include "lib/save/slots.h"
#include "lib/transport/gathering.h"
#include "lib/transport/irradiance.h"
#include "lib/transport/shooting.h"
#include "lib/transport/unshot.h"
#include "lib/vertices/digest.h"
#include "lib/vertices/vertex_gather.h"
#include "lib/vertices/vertex_radiosity.h"

namespace fixrad {

/// What a solver has room for, at compile time. Spans: a row needs at most two more than twice the faces, and
/// two more for each pair of faces that pierce each other; `fixrad info` prints what a scene really uses.
/// PixelResolution: R of the largest table that hemicube_pixels is to use; 0 leaves the item buffer out.
template <uint16_t Vertices, uint16_t Faces, uint16_t Elements, uint16_t Spans = 2 * Faces + 2,
          uint8_t Channels = 3, uint16_t PixelResolution = 0>
struct Limits {
  static constexpr uint16_t vertices = Vertices, faces = Faces, elements = Elements, spans = Spans;
  static constexpr uint8_t channels = Channels;
  static constexpr uint16_t pixel_resolution = PixelResolution;
};

/// The sizes in Limits as numbers, for sizing before there is a type.
struct Sizes {
  uint32_t vertices, faces, elements, spans, channels, pixel_resolution;
};

/// Bytes of a solver's arrays; equal on every target. A further element costs 6 channels + 4 bytes.
constexpr uint32_t pool_bytes(const Sizes& s) {
  return s.vertices * static_cast<uint32_t>(sizeof(Direction)) +
         s.faces * static_cast<uint32_t>(sizeof(FaceView)) + s.spans * static_cast<uint32_t>(sizeof(Span)) +
         s.elements * (4 * s.channels + 4) + 4 * s.channels * account_words(s.elements, s.faces) +
         s.pixel_resolution * s.pixel_resolution * static_cast<uint32_t>(sizeof(Item));
}

/// Bytes of memory that hold every saved state of a scene of these sizes; see saved_bytes().
constexpr uint32_t saved_bytes(const Sizes& s) {
  return saved_bytes(s.elements, s.faces, s.channels);
}

/// Bytes of everything else in a solver on a target with pointers of `pointer_bytes`, rounded up to whole
/// words.
constexpr uint32_t state_bytes(uint32_t pointer_bytes) {
  return 26 * pointer_bytes + 232;
}

/// All the memory of a radiosity solution, in one object without pointers to anything but the caller's scene.
/// Not to be copied or moved. Every member function is meant for one thread; step() may be called from a main
/// loop.
template <class L>
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// Checks `scene` and starts its solution; anything but ok leaves the solver as it was. The scene's tables
  /// must outlive it.
  [[nodiscard]] Status load(const Scene& scene, const Settings& settings = {}) {
    const Status status = check_scene(scene, {L::vertices, L::faces, L::elements, L::channels});
    if (status == Status::ok) {
      state_.work = {directions_, views_, spans_, items_, item_count, L::spans, 0, 0, 0, {}, 0};
      state_.row = {share_, scene.element_count, 0, 0};
      state_.received = received_;
      state_.accounts = accounts_;
      reset(state_, scene, settings);
    }
    return status;
  }

  /// One shot; see shoot().
  [[nodiscard]] Status step() { return shoot(state_); }

  /// At most `budget` units of a shot, whose instructions docs/bounded_time.md bounds; in_progress until it
  /// is complete. See shoot_for().
  [[nodiscard]] Status step(uint32_t budget) { return shoot_for(state_, budget); }

  /// The solution at a vertex, see vertex_radiosity(); `with_ambient` adds the estimate of what is still
  /// unshot.
  Radiosity vertex_radiosity(const VertexMap& map, uint32_t vertex, int channel,
                             bool with_ambient = false) const {
    const Radiosity ambient = with_ambient ? ambient_radiosity(state_, channel) : Radiosity::from_raw(0);
    return fixrad::vertex_radiosity(state_, map, vertex, channel, ambient);
  }

  /// What states of this solution are known by: once, right after load(); see identify().
  Identity identify() { return fixrad::identify(state_); }

  /// Writes the state between two shots into `sink`; see save_state().
  [[nodiscard]] SaveStatus save(const Identity& identity, const StateSink& sink,
                                uint32_t sequence = 0) const {
    return save_state(state_, identity, sink, sequence);
  }

  /// Goes on from a saved state of the same scene and settings, which have been loaded; see load_state().
  [[nodiscard]] SaveStatus resume(const Identity& identity, const StateSource& source) {
    return load_state(state_, identity, source);
  }

  State& state() { return state_; }
  const State& state() const { return state_; }

 private:
  static constexpr uint32_t item_count = static_cast<uint32_t>(L::pixel_resolution) * L::pixel_resolution;

  State state_;
  int32_t received_[static_cast<uint32_t>(L::elements) * L::channels];
  int32_t accounts_[account_words(L::elements, L::faces) * L::channels];
  FaceView views_[L::faces];
  Direction directions_[L::vertices];
  Span spans_[L::spans];
  Item items_[item_count > 0 ? item_count : 1];
  uint32_t share_[L::elements];
};

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "lib/transport/state.h"

namespace fixrad::host {

/// One eye point of a fixed-point run.
struct RecordedEye {
  EyeSample sample;
  int resolution;  ///< R of the table that it was sampled with
};

/// One shot of a fixed-point run.
struct RecordedShot {
  bool is_emission;                       ///< of the only element, else reflected light
  std::vector<std::uint16_t> elements;    ///< that shot
  std::size_t first_eye, eye_count;       ///< into Recorder::eyes()
  std::array<double, kMaxChannels> more;  ///< flux sent beyond the unshot flux: lent, or kept back (below 0)
};

/// Writes down what a fixed-point run does, so that its twin in double can replay it: which elements shot,
/// from which eye points, and how much they overshot. Put observer() into the run's Settings; the recorder
/// must stay where it is until the run ends.
class Recorder {
 public:
  /// `state` is that of the run.
  explicit Recorder(const State& state) : state_(&state) {}
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  Observer observer();
  const std::vector<RecordedShot>& shots() const { return shots_; }
  const std::vector<RecordedEye>& eyes() const { return eyes_; }

  /// Drops the shots so far, once a twin has replayed them: a run of millions need not be kept whole.
  void forget_shots();

 private:
  void take_shot(const Shot& shot);
  void withdraw() { eyes_.resize(shot_eyes_); }

  const State* state_;
  std::vector<RecordedShot> shots_;
  std::vector<RecordedEye> eyes_;
  std::size_t shot_eyes_ = 0;  // eyes of complete shots; those behind it belong to the coming one
};

}  // namespace fixrad::host

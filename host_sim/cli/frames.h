// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "host_sim/cli/session.h"

namespace fixrad::host {

/// Throws InputError unless --frames can be followed: the folder exists or can be made, and the solver
/// shoots.
void check_frames(const CommonOptions& options);

/// Keeps what the solver knows after 1, 2, 4, ... shots and makes pictures of it.
class FrameRecorder {
 public:
  FrameRecorder() = default;
  FrameRecorder(const FrameRecorder&) = delete;
  FrameRecorder& operator=(const FrameRecorder&) = delete;

  /// What bake() is to be given; nothing without --frames.
  std::function<Observer(const State&)> observer(const CommonOptions& options);

  /// Writes SHOTS.png and SHOTS_ambient.png (the ambient estimate of what is unshot added, Cohen et al. 1988)
  /// for each state that was kept, SHOTS.png of the finished solution, and index.html, which shows them side
  /// by side. One exposure and one camera for all, those of the finished solution. False once the user has
  /// interrupted; what is written by then is complete.
  bool write(const CommonOptions& options, const LoadedScene& scene, const BakeResult& result,
             const BakedMesh& mesh) const;

 private:
  struct Moment {
    State state;
    std::vector<std::int32_t> received, accounts;
    double unshot_fraction;
  };
  void keep();

  const State* watched_ = nullptr;
  std::vector<Moment> moments_;
};

}  // namespace fixrad::host

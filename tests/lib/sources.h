// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tests/lib/solution.h"

namespace fixrad::host {

/// Unshot flux that a source could send, the sum of magnitudes over the channels, from what its elements
/// reflect and have sent, or from what the solver keeps of a face.
std::uint64_t unshot_flux(const State& state, const EyeSource& source);

/// All sources of one kind.
std::vector<EyeSource> sources_of(const Scene& scene, SourceKind kind);

/// The most that unshot_flux() has for any source of `kind`.
std::uint64_t largest_unshot(const State& state, SourceKind kind);

/// One shot as an observer saw it.
struct SeenShot {
  Shot shot;
  bool begins_pass;       ///< the first one of a pass over the sources of its kind
  std::uint64_t largest;  ///< unshot flux of any source of its kind when the pass began
};

/// Fires the shots of a solution one by one and says of each how it was chosen. Sets the observer of the
/// state's settings; must stay where it is while shots are fired.
class ShotWatch {
 public:
  explicit ShotWatch(Solution& solution);
  ShotWatch(const ShotWatch&) = delete;
  ShotWatch& operator=(const ShotWatch&) = delete;

  /// Fires the next shot; anything but ok says that there was none.
  Status next(SeenShot& seen);

 private:
  State& state_;
  Shot shot_ = {};
  SeenShot last_ = {};
  std::uint64_t last_threshold_ = 0;
};

}  // namespace fixrad::host

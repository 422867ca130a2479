// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "firmware/float_peer/solver.h"
#include "tests/lib/solution.h"

namespace fixrad::host {

/// Lune rows of R = 4 to 32, all that the peer has; 4 for probes.
Settings peer_settings(Fraction stop);

/// The storage that all tests share.
using Peer = peer::Solver<Limits<400, 300, 5000, 2000>>;

/// The float peer on the scene of a core's solution, with the core's settings; not yet solved. Fails the
/// current test if it does not load.
class PeerSolution {
 public:
  explicit PeerSolution(const Solution& core);
  /// On a scene of its own, which must outlive it.
  PeerSolution(const DeviceScene& device, const Settings& settings);

  /// One shot.
  Status step() { return peer_->step(); }
  /// Shoots until the status is not ok; returns it.
  Status run();

  const Peer& solver() const { return *peer_; }
  const peer::State& state() const { return peer_->state(); }

  /// Radiosity of all elements, one channel, unit of the model's emission.
  std::vector<double> radiosities(int channel = 0) const;
  /// emitted - absorbed - unshot - escaped - back over emitted, the largest of all channels.
  double imbalance() const;

 private:
  double unshot(std::size_t channel) const;
  double reflected(std::size_t element, std::size_t channel) const;
  double received(std::size_t element, std::size_t channel) const;

  const DeviceScene& device_;
  std::unique_ptr<Peer> peer_;
};

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// How a scene is solved: what must hold after every shot and in the end.
#include "tests/stability/property_checks.h"

namespace fixrad::host {
namespace {

// The ledger's books, channel by channel.
class Books {
 public:
  explicit Books(const State& state) : state_(state) {}

  std::string audit() {
    for (std::uint8_t c = 0; c < state_.scene.channels; ++c) {
      const Ledger sum = ledger(state_, c);
      if (sum.imbalance() != 0) {
        return at(c, "the ledger is " + std::to_string(sum.imbalance()) + " units off");
      }
      const std::uint64_t unshot = sum_unshot(state_, c).magnitude;
      if (!state_.settings.overshoot && unshot > unshot_[c]) {
        return at(c, "unshot flux grew to " + std::to_string(unshot));
      }
      unshot_[c] = unshot;
    }
    return {};
  }

 private:
  std::string at(int c, const std::string& what) const {
    return "shot " + std::to_string(state_.shots) + " channel " + std::to_string(c) + ": " + what;
  }

  const State& state_;
  std::uint64_t unshot_[kMaxChannels] = {~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}};
};

std::string leak(const State& state) {
  if (!state.is_closed) {
    return "the room is not closed on the grid";
  }
  for (int c = 0; c < state.scene.channels; ++c) {
    if (state.escaped[c] != 0 || state.back[c] != 0) {
      return "channel " + std::to_string(c) + ": escaped " + std::to_string(state.escaped[c]) + ", back " +
             std::to_string(state.back[c]);
    }
  }
  return {};
}

}  // namespace

std::string refusal(const Bench& bench) {
  return std::string("the core refuses the scene: ") + describe(bench.status());
}

std::string unsolved(const Bench& bench) {
  return std::string("no end: ") + describe(bench.status());
}

std::string keep_books(const RandomScene& scene) {
  Bench bench(model_of(scene), scene, settings_of(scene));
  if (bench.status() != Status::ok) {
    return refusal(bench);
  }
  State& state = bench.state();
  Books books(state);
  Status status = Status::ok;
  while (status == Status::ok && state.shots < Bench::kMostShots) {
    const std::string fault = books.audit();
    if (!fault.empty()) {
      return fault;
    }
    status = shoot(state);
  }
  if (status != Status::converged) {
    return std::string("no end: ") + describe(status);
  }
  return scene.is_closed ? leak(state) : std::string();
}

// Solved in one go, and with everything read that can be read between two shots.
std::string read_on_the_way(const RandomScene& scene) {
  Bench whole(model_of(scene), scene, settings_of(scene)), sliced(model_of(scene), scene, settings_of(scene));
  if (whole.status() != Status::ok) {
    return refusal(whole);
  }
  Status status = Status::ok;
  while (status == Status::ok && sliced.state().shots < Bench::kMostShots) {
    unshot_fraction(sliced.state());
    for (int c = 0; c < sliced.state().scene.channels; ++c) {
      ledger(sliced.state(), c);
      element_radiosity(sliced.state(), 0, c, ambient_radiosity(sliced.state(), c));
    }
    status = shoot(sliced.state());
  }
  if (!whole.run()) {
    return unsolved(whole);
  }
  return whole.received() == sliced.received() && whole.state().shots == sliced.state().shots
             ? std::string()
             : "another flux in slices than in one go";
}

}  // namespace fixrad::host

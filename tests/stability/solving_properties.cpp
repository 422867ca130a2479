// SPDX-License-Identifier: MIT
// How a scene is solved: what must hold after every shot and in the end.
#include <algorithm>

#include "lib/save/resume.h"
#include "lib/save/save.h"
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

namespace {

// Small numbers that depend on the scene's seed alone.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : last_(static_cast<std::uint32_t>(seed)) {}

  std::uint32_t below(std::uint32_t n) {
    last_ = last_ * 1664525u + 1013904223u;
    return (last_ >> 16) % n;
  }

 private:
  std::uint32_t last_;
};

// The power fails: what is saved now, maybe in the middle of a shot, is all that another solver goes on from.
std::string hand_over(Bench& from, Bench& to) {
  std::vector<std::uint8_t> saved;
  const StateSink sink = {&saved, [](void* context, const std::uint8_t* bytes, std::uint8_t count) {
                            auto& to_bytes = *static_cast<std::vector<std::uint8_t>*>(context);
                            to_bytes.insert(to_bytes.end(), bytes, bytes + count);
                            return true;
                          }};
  const StateSource source = {
      &saved, [](void* context, std::uint32_t offset, std::uint8_t* bytes, std::uint8_t count) {
        const auto& all = *static_cast<const std::vector<std::uint8_t>*>(context);
        if (offset + std::uint64_t{count} > all.size()) {
          return false;
        }
        std::copy_n(all.begin() + offset, count, bytes);
        return true;
      }};
  const Identity identity = identify(to.state());
  if (save_state(from.state(), identity, sink, 0) != SaveStatus::ok) {
    return "the state is not saved";
  }
  const SaveStatus status = load_state(to.state(), identity, source);
  return status == SaveStatus::ok ? std::string() : "refused: " + std::to_string(static_cast<int>(status));
}

// One shot in slices of random budgets, once given up half way; the books must balance between any two.
Status shoot_in_slices(State& state, Dice& dice) {
  bool may_give_up = true;
  for (;;) {
    const Status status = shoot_for(state, 1 + dice.below(40));
    for (int c = 0; c < state.scene.channels; ++c) {
      if (ledger(state, c).imbalance() != 0) {
        return Status::flux_overflow;
      }
    }
    if (status != Status::in_progress) {
      return status;
    }
    if (may_give_up && dice.below(30) == 0) {
      abandon_shot(state);
      may_give_up = false;
    }
  }
}

}  // namespace

// Solved in one go, and in slices, by two solvers of which the second takes over in the middle of a shot.
std::string solve_in_slices(const RandomScene& scene) {
  const Settings settings = settings_of(scene);
  Bench whole(model_of(scene), scene, settings), first(model_of(scene), scene, settings),
      second(model_of(scene), scene, settings);
  if (whole.status() != Status::ok) {
    return refusal(whole);
  }
  Dice dice(scene.seed);
  Status status = Status::ok;
  const std::uint32_t until = dice.below(30);
  while (status == Status::ok && first.state().shots < until) {
    status = shoot_in_slices(first.state(), dice);
  }
  if (status == Status::ok) {
    shoot_for(first.state(), 1 + dice.below(100));
  }
  const std::string fault = hand_over(first, second);
  if (!fault.empty()) {
    return fault;
  }
  do {
    status = shoot_in_slices(second.state(), dice);
  } while (status == Status::ok && second.state().shots < Bench::kMostShots);
  if (!whole.run()) {
    return unsolved(whole);
  }
  return whole.received() == second.received() && whole.state().shots == second.state().shots
             ? std::string()
             : "another flux in slices than in one go";
}

}  // namespace fixrad::host

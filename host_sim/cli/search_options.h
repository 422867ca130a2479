// SPDX-License-Identifier: MIT
// What `sweep` and `tune` take beyond the scene.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "host_sim/cli/session.h"
#include "host_sim/sweep/setting.h"
#include "host_sim/sweep/sweep.h"
#include "host_sim/sweep/tune.h"

namespace fixrad::host {

/// What the user wants of `tune`.
struct TuneOptions {
  std::string target;
  std::optional<std::uint32_t>
      ram;                       ///< bytes that the solver may take; else those of the profile for the chip
  double max_error_percent = 2;  ///< mean over faces against the truth
  std::optional<double> max_worst_percent;  ///< of the worst face
  std::optional<double> max_instructions;   ///< or cycles, where the target's model counts these
};

void add_sweep_options(CLI::App& command, CommonOptions& options, Choices& choices);
void add_tune_options(CLI::App& command, CommonOptions& options, TuneOptions& tune);

/// Each returns an ExitCode and throws InputError. `program` is what the user calls the tool.
int run_sweep(const CommonOptions& options, const Choices& choices);
int run_tune(const CommonOptions& options, const TuneOptions& tune_options, const std::string& program);

/// `PROGRAM bake SCENE` with the options on reading the scene: a command to which those of a setting are
/// added.
std::string bake_command_start(const std::string& program, const CommonOptions& options);

/// Settings done, on a terminal a line that is written over; nothing in a log.
class Counter {
 public:
  /// `count` settings in all, 0 if nobody knows.
  Counter(const CommonOptions& options, std::size_t count);
  ~Counter();
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  /// The next setting begins.
  void next(const BakeOptions& setting);

 private:
  std::size_t count_, done_ = 0;
  bool visible_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Solves settings one after the other; `take` gets each finished point. False once the user has interrupted.
bool solve_all(const CommonOptions& options, const PreparedScene& scene, const Truth& truth,
               const std::vector<BakeOptions>& settings, const std::function<void(const SweepPoint&)>& take);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// What `sweep` and `tune` take beyond the scene.
#pragma once

#include <functional>
#include <string>

#include "host_sim/cli/session.h"
#include "host_sim/sweep/setting.h"
#include "host_sim/sweep/sweep.h"

namespace fixrad::host {

/// The wish that `tune` fulfils.
struct Wish {
  std::string target;
  std::uint32_t ram =
      0;  ///< bytes that the solver may take; 0: those of the profile that the chip stands for
  double max_error = 0.02;                 ///< mean over faces against the truth
  std::optional<double> max_instructions;  ///< or cycles, where the target's model counts these
};

void add_sweep_options(CLI::App& command, CommonOptions& options, Choices& choices);
void add_tune_options(CLI::App& command, CommonOptions& options, Wish& wish);

/// Each returns an ExitCode and throws InputError. `program` is what the user calls the tool.
int run_sweep(const CommonOptions& options, const Choices& choices);
int run_tune(const CommonOptions& options, const Wish& wish, const std::string& program);

/// `PROGRAM bake SCENE` with the options on reading the scene: a command to which those of a setting are
/// added.
std::string bake_command_start(const std::string& program, const CommonOptions& options);

/// Solves settings one after the other, with the number done, the setting and the time left on a terminal.
/// False once the user has interrupted; `take` gets each finished point.
bool solve_all(const CommonOptions& options, const PreparedScene& scene, const Truth& truth,
               const std::vector<BakeOptions>& settings, const std::function<void(const SweepPoint&)>& take);

}  // namespace fixrad::host

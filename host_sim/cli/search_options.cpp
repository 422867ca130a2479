// SPDX-License-Identifier: MIT
#include "host_sim/cli/search_options.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "host_sim/cli/info_page.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

CLI::Validator fraction() {
  return CLI::Range(1e-9, 0.999999, "FRACTION");
}

}  // namespace

Counter::Counter(const CommonOptions& options, std::size_t count)
    : count_(count), visible_(!options.quiet && isatty(STDERR_FILENO) != 0) {}

Counter::~Counter() {
  if (visible_) {
    std::fputs("\r\033[K", stderr);
  }
}

void Counter::next(const BakeOptions& setting) {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (visible_ && count_ > 0) {
    const double left =
        done_ == 0 ? 0 : seconds * static_cast<double>(count_ - done_) / static_cast<double>(done_);
    std::fprintf(stderr, "\r[%zu of %zu] %s, profile %s, %.0f s left \033[K", done_ + 1, count_,
                 setting.engine.c_str(), setting.profile.c_str(), left);
  } else if (visible_) {
    std::fprintf(stderr, "\r[%zu] %s, profile %s, %u elements, %.0f s \033[K", done_ + 1,
                 setting.engine.c_str(), setting.profile.c_str(), setting.elements.value_or(0), seconds);
  }
  ++done_;
}

void add_info_options(CLI::App& command, CommonOptions& options, InfoOptions& info) {
  std::vector<std::string> targets;
  for (const CostModel& model : cost_models()) {
    targets.push_back(model.target);
  }
  command.add_option("--target", info.target, "Core whose instructions count (default: the profile's chip)")
      ->check(CLI::IsMember(targets));
  command
      .add_option("--max-error", info.max_error_percent,
                  "Look for the elements that keep the mean error over faces to this, in per cent; takes "
                  "seconds to minutes")
      ->check(CLI::Range(0.01, 100.0, "PERCENT"));
  command.add_option("--json", options.json, "Write the figures to this file too");
}

void add_sweep_options(CLI::App& command, CommonOptions& options, Choices& choices) {
  command.add_option("--profile", choices.profiles, "Profiles to solve for")
      ->check(CLI::IsMember({"tiny", "small", "medium", "large", "host"}))
      ->delimiter(',')
      ->default_str("tiny,small,medium,large");
  command.add_option("--engine", choices.engines, "Engines to compare")
      ->check(CLI::IsMember(swept_engines()))
      ->delimiter(',')
      ->default_str(CLI::detail::join(swept_engines(), ",") + "; rays up to 1000 elements");
  command.add_option("--resolution", choices.resolutions, "Resolutions R, each for the engines that have it")
      ->check(CLI::IsMember({4, 8, 16, 32, 64, 128}))
      ->delimiter(',')
      ->default_str("lunes 16,64; rows, pixels 16,32,64; rays 4,8,16 a pair");
  command
      .add_option("--flux-per-row", choices.flux_per_row,
                  "Parts of the emitted flux that a row of samples stands for")
      ->check(fraction())
      ->delimiter(',')
      ->default_str("4, 2, 1, 1/2 and 1/4 times the profile's; 2 and 1/2 for engines other than lunes");
  command
      .add_option("--flux-per-eye", choices.flux_per_eye,
                  "Parts of the emitted flux that an eye point of an element stands for (default: the "
                  "profile's choice)")
      ->check(fraction())
      ->delimiter(',');
  command.add_option("--elements", choices.elements, "Most elements (default: the profile's choice)")
      ->check(CLI::Range(1u, 60000u))
      ->delimiter(',');
  command
      .add_option("--unshot", options.bake.unshot,
                  "Stop when the unshot flux is under this part of the emitted flux")
      ->check(fraction())
      ->capture_default_str();
}

void add_tune_options(CLI::App& command, CommonOptions& options, TuneOptions& tune) {
  std::vector<std::string> targets;
  for (const CostModel& model : cost_models()) {
    targets.push_back(model.target);
  }
  command.add_option("--target", tune.target, "Core that the solver is to run on")
      ->check(CLI::IsMember(targets))
      ->required();
  command
      .add_option("--ram", tune.ram, "Bytes that the solver may take (default: those of the core's profile)")
      ->check(CLI::Range(1u, 1u << 30));
  command
      .add_option("--max-error", tune.max_error_percent,
                  "Mean error of face means against path-traced truth, in per cent")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--max-worst", tune.max_worst_percent,
                  "Error of the worst face that has at least a tenth of the mean radiosity, in per cent")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--max-instructions", tune.max_instructions,
                  "Most instructions (cycles on AVR), such as 35e6")
      ->check(CLI::PositiveNumber);
  command.add_option("--json", options.json, "Write what was found to this file too");
}

std::string bake_command_start(const std::string& program, const CommonOptions& options) {
  std::string text = shell_word(program) + " bake " + shell_word(options.scene);
  text += options.read.two_sided ? " --two-sided" : "";
  text += options.read.flip ? " --flip" : "";
  if (options.read.max_reflectance) {
    text += " --max-reflectance ";
    append_number(text, *options.read.max_reflectance);
  }
  return text;
}

bool solve_all(const CommonOptions& options, const PreparedScene& scene, const Truth& truth,
               const std::vector<BakeOptions>& settings, const std::function<void(const SweepPoint&)>& take) {
  Counter counter(options, settings.size());
  for (const BakeOptions& setting : settings) {
    counter.next(setting);
    const SweepPoint point =
        solve_setting(scene, truth, setting, [](std::uint32_t, double, double) { return !is_interrupted(); });
    if (point.interrupted || is_interrupted()) {
      return false;
    }
    take(point);
  }
  return true;
}

}  // namespace fixrad::host

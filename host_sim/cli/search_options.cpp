// SPDX-License-Identifier: MIT
#include "host_sim/cli/search_options.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

CLI::Validator fraction() {
  return CLI::Range(1e-9, 0.999999, "FRACTION");
}

// A line that is written over on a terminal; nothing in a log.
class Counter {
 public:
  Counter(const CommonOptions& options, std::size_t count)
      : count_(count), visible_(!options.quiet && isatty(STDERR_FILENO) != 0) {}
  ~Counter() {
    if (visible_) {
      std::fputs("\r\033[K", stderr);
    }
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  void show(std::size_t done, const BakeOptions& now) const {
    if (visible_) {
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
      const double left =
          done == 0 ? 0 : seconds * static_cast<double>(count_ - done) / static_cast<double>(done);
      std::fprintf(stderr, "\r[%zu of %zu] %s, profile %s, %.0f s left \033[K", done + 1, count_,
                   now.engine.c_str(), now.profile.c_str(), left);
    }
  }

 private:
  std::size_t count_;
  bool visible_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

void add_sweep_options(CLI::App& command, CommonOptions& options, Choices& choices) {
  command.add_option("--profile", choices.profiles, "Profiles to solve for")
      ->check(CLI::IsMember({"tiny", "small", "medium", "large", "host"}))
      ->delimiter(',')
      ->default_str("tiny,small,medium,large");
  command.add_option("--engine", choices.engines, "Engines to compare")
      ->check(CLI::IsMember(swept_engines()))
      ->delimiter(',')
      ->default_str(CLI::detail::join(swept_engines(), ","));
  command.add_option("--resolution", choices.resolutions, "Resolutions R")
      ->check(CLI::IsMember({8, 16, 32, 64, 128}))
      ->delimiter(',')
      ->default_str("16,32,64");
  command.add_option("--flux-per-eye", choices.flux_per_eye, "Emitted flux an eye point, as fractions")
      ->check(fraction())
      ->delimiter(',')
      ->default_str("0.006,0.03");
  command.add_option("--elements", choices.elements, "Most elements (default: the profile's choice)")
      ->check(CLI::Range(1u, 60000u))
      ->delimiter(',');
  command
      .add_option("--unshot", options.bake.unshot,
                  "Stop when the unshot flux is under this part of the emitted flux")
      ->check(fraction())
      ->capture_default_str();
}

void add_tune_options(CLI::App& command, CommonOptions& options, Wish& wish) {
  std::vector<std::string> targets;
  for (const CostModel& model : cost_models()) {
    targets.push_back(model.target);
  }
  command.add_option("--target", wish.target, "Core that the solver is to run on")
      ->check(CLI::IsMember(targets))
      ->required();
  command
      .add_option("--ram", wish.ram, "Bytes that the solver may take (default: those of the core's profile)")
      ->check(CLI::Range(1u, 1u << 30));
  command
      .add_option_function<double>(
          "--max-error", [&wish](const double& percent) { wish.max_error = percent / 100; },
          "Mean error of face means against path-traced truth, in per cent")
      ->check(CLI::PositiveNumber)
      ->default_str("2");
  command
      .add_option("--max-instructions", wish.max_instructions,
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
  const Counter counter(options, settings.size());
  for (std::size_t i = 0; i < settings.size(); ++i) {
    counter.show(i, settings[i]);
    const SweepPoint point = solve_setting(scene, truth, settings[i],
                                           [](std::uint32_t, double, double) { return !is_interrupted(); });
    if (point.interrupted || is_interrupted()) {
      return false;
    }
    take(point);
  }
  return true;
}

}  // namespace fixrad::host

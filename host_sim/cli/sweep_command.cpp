// SPDX-License-Identifier: MIT
#include <filesystem>

#include "host_sim/cli/search_options.h"
#include "host_sim/cli/sweep_page.h"
#include "host_sim/report/data_page.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

bool is_page(const std::string& output) {
  return std::filesystem::path(output).extension() == ".html";
}

Choices with_defaults(Choices choices) {
  const auto fill = [](auto& list, auto defaults) {
    if (list.empty()) {
      list = std::move(defaults);
    }
  };
  choices.leaves_out_slow = choices.engines.empty();
  fill(choices.profiles, std::vector<std::string>{"tiny", "small", "medium", "large"});
  fill(choices.engines, swept_engines());
  return choices;
}

std::string summary(const std::vector<SweepPoint>& points) {
  std::vector<double> seconds, errors;
  for (const SweepPoint& point : points) {
    seconds.push_back(point.host_seconds);
    errors.push_back(point.mean_error);
  }
  return std::to_string(points.size()) + " settings solved, " +
         std::to_string(pareto_frontier(seconds, errors).size()) + " of them on the frontier of host seconds";
}

}  // namespace

int run_sweep(const CommonOptions& options, const Choices& choices) {
  bool wants_page = false;
  for (const std::string& output : options.outputs) {
    check_folder(output);
    wants_page = wants_page || is_page(output);
  }
  if (wants_page) {
    page_with("", "");  // says now, not after the work, if this tool has no page
  }
  const auto scene = load_scene(options);
  exit_on_interrupt();
  const std::vector<BakeOptions> settings =
      all_settings(scene->prepared, options.bake, with_defaults(choices));
  if (settings.empty()) {
    throw InputError(
        options.scene +
        ": error: the scene fits none of these profiles with these settings; add a larger one to --profile "
        "(engine contour needs a scene where no face can hide another)");
  }
  say(options, "tracing the truth, then solving " + std::to_string(settings.size()) + " settings");
  const Truth truth = trace_truth(scene->prepared);
  catch_interrupt();
  std::vector<SweepPoint> points;
  Showcase showcase;
  if (!solve_all(options, scene->prepared, truth, settings,
                 [&](const SweepPoint& point) { points.push_back(point); }) ||
      (wants_page && !make_showcase(options, *scene, truth, points, showcase))) {
    say(options, "interrupted: nothing written");
    return kInterrupted;
  }
  say(options, summary(points));
  const std::string start = bake_command_start("fixrad", options);
  for (const std::string& output : options.outputs) {
    write_text(output, is_page(output) ? sweep_page(options, start, truth, points, showcase)
                                       : sweep_csv(points, start));
    say(options, "wrote " + output);
  }
  return kDone;
}

}  // namespace fixrad::host

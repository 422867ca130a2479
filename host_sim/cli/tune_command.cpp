// SPDX-License-Identifier: MIT
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/cli/search_options.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

using Json = nlohmann::ordered_json;

// The memory of the profile that stands for a core, where none is asked for.
std::uint32_t usual_ram(const std::string& target) {
  const char* profile = target == "atmega2560"                            ? "tiny"
                        : target == "cortex-m0"                           ? "small"
                        : target == "cortex-m4f" || target == "cortex-m7" ? "large"
                                                                          : "medium";
  return find_profile(profile)->ram_bytes;
}

std::string percent(double part) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * part);
  return text;
}

std::string count(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g M", value / 1e6);
  return text;
}

std::string figures(const SweepPoint& point, const CostModel& model) {
  return percent(point.mean_error) + " mean error (worst face " + percent(point.worst_error) + "), " +
         std::to_string(ram_on(model, point)) + " bytes of RAM, " + count(cost_on(model, point).value_or(0)) +
         " " + model.unit;
}

std::string error_text(const Wish& wish) {
  const std::string worst = wish.max_worst ? " (worst face " + percent(*wish.max_worst) + ")" : "";
  return percent(wish.max_error) + " mean error" + worst;
}

std::string wish_text(const Wish& wish) {
  std::string text = std::to_string(wish.ram) + " bytes of RAM";
  return text + (wish.max_cost ? " and " + count(*wish.max_cost) + " " + wish.model->unit : "") + " on " +
         wish.model->target;
}

Json point_json(const SweepPoint& point, const CostModel& model, const std::string& start) {
  return {{"command", start + " " + point.command},
          {"engine", point.options.engine},
          {"resolution", point.resolution},
          {"flux_per_row", point.flux_per_row},
          {"flux_per_eye", point.flux_per_eye},
          {"elements", point.elements},
          {"patches", point.patches},
          {"ram_bytes", ram_on(model, point)},
          {"mean_error", point.mean_error},
          {"worst_error", point.worst_error},
          {model.unit, static_cast<std::uint64_t>(cost_on(model, point).value_or(0))}};
}

Json to_json(const Wish& wish, const Tuned& tuned, const Truth& truth, const std::string& start) {
  Json json = {{"target", wish.model->target},
               {"ram", wish.ram},
               {"max_error", wish.max_error},
               {"max_worst", wish.max_worst ? Json(*wish.max_worst) : Json()},
               {"truth_standard_error", truth.standard_error},
               {"model_residual", wish.model->residual},
               {"solved", tuned.solved},
               {"found", tuned.cheapest.has_value()}};
  const auto add = [&](const char* name, const std::optional<SweepPoint>& point) {
    if (point) {
      json[name] = point_json(*point, *wish.model, start);
    }
  };
  add("cheapest", tuned.cheapest);
  if (!tuned.cheapest) {
    add("closest", tuned.closest);
    add("enough", tuned.enough);
  }
  return json;
}

std::string out_of_reach(const Wish& wish, const Tuned& tuned, const std::string& scene,
                         const std::string& start) {
  const auto with_command = [&](const SweepPoint& point) {
    return figures(point, *wish.model) + "\n    " + start + " " + point.command;
  };
  std::string text = scene + ": error: " + error_text(wish) + " is out of reach in " + wish_text(wish) +
                     "\n  closest within these: ";
  text += tuned.closest ? with_command(*tuned.closest) : std::string("nothing fits");
  text += "\n  for that error: ";
  return text + (tuned.enough ? with_command(*tuned.enough)
                              : std::string("not found in the memory of profile large either"));
}

std::string explanation(const Wish& wish, const Tuned& tuned, const Truth& truth) {
  const std::string hint =
      wish.max_worst ? "" : "\nthe worst face is not part of the wish; --max-worst bounds it";
  return "cheapest of " + std::to_string(tuned.solved) + " settings for at most " + error_text(wish) +
         " in " + wish_text(wish) + ": " + figures(*tuned.cheapest, *wish.model) +
         "\nerror: means of faces " + "against path-traced truth, whose standard error is " +
         percent(truth.standard_error) + "; " + wish.model->unit + ": a model within " +
         percent(wish.model->residual) + " of measured solutions" + hint;
}

}  // namespace

int run_tune(const CommonOptions& options, const TuneOptions& tune_options, const std::string& program) {
  check_folder(options.json);
  Wish wish;
  wish.model = find_cost_model(tune_options.target);
  wish.ram = tune_options.ram.value_or(usual_ram(tune_options.target));
  wish.max_error = tune_options.max_error_percent / 100;
  if (tune_options.max_worst_percent) {
    wish.max_worst = *tune_options.max_worst_percent / 100;
  }
  wish.max_cost = tune_options.max_instructions;
  const auto scene = load_scene(options);
  exit_on_interrupt();
  const Truth truth = trace_truth(scene->prepared);
  Tuned tuned;
  {
    Counter counter(options, 0);
    tuned = tune(scene->prepared, wish, options.bake, [&](const BakeOptions& setting) {
      counter.next(setting);
      SweepPoint point = solve_setting(scene->prepared, truth, setting,
                                       [](std::uint32_t, double, double) { return !is_interrupted(); });
      point.interrupted = point.interrupted || is_interrupted();
      return point;
    });
  }
  catch_interrupt();  // from here on a file may be open
  if (tuned.interrupted) {
    say(options, "interrupted: nothing found yet");
    return kInterrupted;
  }
  const std::string start = bake_command_start(program, options);
  if (!options.json.empty()) {
    write_text(options.json, to_json(wish, tuned, truth, start).dump(2) + "\n");
  }
  if (!tuned.cheapest) {
    throw InputError(out_of_reach(wish, tuned, options.scene, start));
  }
  std::printf("%s %s\n", start.c_str(), tuned.cheapest->command.c_str());
  say(options, explanation(wish, tuned, truth));
  return kDone;
}

}  // namespace fixrad::host

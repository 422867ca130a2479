// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "host_sim/cli/info_page.h"
#include "host_sim/cli/search_options.h"
#include "host_sim/cli/session.h"

namespace fixrad::host {
namespace {

CLI::Validator output_suffix(const std::vector<std::string>& known) {
  return CLI::Validator(
      [known](std::string& text) {
        const std::string suffix = std::filesystem::path(text).extension().string();
        return std::find(known.begin(), known.end(), suffix) != known.end()
                   ? std::string()
                   : text + ": the suffix must be one of " + CLI::detail::join(known, " ");
      },
      "FILE", "output file");
}

int run(int argc, char** argv) {
  CLI::App app("fixrad: radiosity in fixed point, for the smallest devices", "fixrad");
  app.require_subcommand(1);
  CommonOptions options;
  add_quiet(app, options);

  CLI::App* bake =
      app.add_subcommand("bake", "Solve a scene with the fixed-point core and write its lighting");
  add_scene_options(*bake, options);
  add_solver_options(*bake, options);
  add_display_options(*bake, options);
  bake->add_option("-o,--output", options.outputs, "File to write, by its suffix; may be given several times")
      ->check(output_suffix({".hpp", ".glb", ".ply", ".png", ".csv", ".json"}))
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_picture_options(*bake, options.picture);
  add_state_options(*bake, options);
  bake->add_option("--faces-csv", options.faces_csv, "Mean radiosity of every input face, in file order");
  bake->add_flag("--keep-partial", options.keep_partial, "When interrupted, write the solution so far");

  CLI::App* compare =
      app.add_subcommand("compare", "Print the error budget: arithmetic, form factors, mesh, total");
  add_scene_options(*compare, options);
  add_solver_options(*compare, options);
  compare->add_option("--json", options.json, "Write the figures to this file too");
  add_point_options(*compare, options);

  CLI::App* exported =
      app.add_subcommand("export", "Solve a scene and write it for a firmware to solve again");
  add_scene_options(*exported, options);
  add_solver_options(*exported, options);
  add_view_options(*exported, options.picture,
                   "Pixels of a picture that the firmware is to draw, at most 2048 a side");
  exported->add_option("-o,--output", options.outputs, "C++ header to write; its stem names the namespace")
      ->check(output_suffix({".h", ".hpp"}))
      ->expected(1)
      ->required();

  CLI::App* factors = app.add_subcommand("form-factors", "Area-averaged form factors between input faces");
  add_scene_options(*factors, options);
  add_solver_options(*factors, options);
  factors->add_option("--csv", options.csv, "File to write: i,j,F")->required();

  CLI::App* truth = app.add_subcommand("truth", "Path-traced mean radiosity of every input face");
  add_scene_options(*truth, options);
  truth->add_option("--csv", options.csv, "File to write: face,material,emits,area,B,standard error of B")
      ->required();
  truth->add_option("--paths", options.paths, "Paths in all")
      ->check(CLI::Range(1000u, 1000000000u))
      ->capture_default_str();

  CLI::App* state = app.add_subcommand("state", "What a saved state of a solution holds");
  state->add_option("FILE", options.state, "File that `bake --save` or a device has written")->required();
  state->add_option("--json", options.json, "Write it to this file too");
  add_quiet(*state, options);

  CLI::App* info = app.add_subcommand("info", "What a scene needs and what it costs on each profile");
  add_scene_options(*info, options);
  add_solver_options(*info, options);
  InfoOptions info_options;
  add_info_options(*info, options, info_options);

  Choices choices;
  CLI::App* sweep =
      app.add_subcommand("sweep", "Speed against error over many settings, as a page or a table");
  add_scene_options(*sweep, options);
  add_sweep_options(*sweep, options, choices);
  sweep
      ->add_option("-o,--output", options.outputs, "File to write, by its suffix; may be given several times")
      ->check(output_suffix({".html", ".csv"}))
      ->expected(1)
      ->required()
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);

  TuneOptions wish;
  CLI::App* tune = app.add_subcommand("tune", "The cheapest setting for a core, its memory and an error");
  add_scene_options(*tune, options);
  add_tune_options(*tune, options, wish);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return kUsage;
  }
  catch_interrupt();
  if (bake->parsed()) {
    return run_bake(options);
  }
  if (compare->parsed()) {
    return run_compare(options);
  }
  if (exported->parsed()) {
    return run_export(options);
  }
  if (truth->parsed()) {
    return run_truth(options);
  }
  if (state->parsed()) {
    return run_state(options);
  }
  if (sweep->parsed()) {
    return run_sweep(options, choices);
  }
  if (tune->parsed()) {
    return run_tune(options, wish, argv[0]);
  }
  return factors->parsed() ? run_form_factors(options) : run_info(options, info_options);
}

}  // namespace
}  // namespace fixrad::host

int main(int argc, char** argv) {
  try {
    return fixrad::host::run(argc, argv);
  } catch (const fixrad::host::InputError& error) {
    std::cerr << error.what() << '\n';
    return fixrad::host::kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "fixrad: error: " << error.what() << '\n';
    return fixrad::host::kBadInput;
  }
}

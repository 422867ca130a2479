// SPDX-License-Identifier: MIT
#include <exception>
#include <filesystem>
#include <iostream>
#include <set>

#include "host_sim/cli/session.h"

namespace fixrad::host {
namespace {

CLI::Validator output_suffix() {
  return CLI::Validator(
      [](std::string& text) {
        static const std::set<std::string> known = {".hpp", ".glb", ".ply", ".png", ".csv", ".json"};
        return known.count(std::filesystem::path(text).extension().string()) != 0
                   ? std::string()
                   : text + ": the suffix must be one of .hpp .glb .ply .png .csv .json";
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
  bake->add_option("-o,--output", options.outputs, "File to write, by its suffix; may be given several times")
      ->check(output_suffix())
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  bake->add_option("--faces-csv", options.faces_csv, "Mean radiosity of every input face, in file order");
  bake->add_flag("--keep-partial", options.keep_partial, "When interrupted, write the solution so far");

  CLI::App* compare =
      app.add_subcommand("compare", "Print the error budget: arithmetic, form factors, mesh, total");
  add_scene_options(*compare, options);
  add_solver_options(*compare, options);
  compare->add_option("--json", options.json, "Write the figures to this file too");

  CLI::App* factors = app.add_subcommand("form-factors", "Area-averaged form factors between input faces");
  add_scene_options(*factors, options);
  add_solver_options(*factors, options);
  factors->add_option("--csv", options.csv, "File to write: i,j,F")->required();

  CLI::App* info = app.add_subcommand("info", "What a scene needs and what it costs on each profile");
  add_scene_options(*info, options);
  add_solver_options(*info, options);

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
  return factors->parsed() ? run_form_factors(options) : run_info(options);
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

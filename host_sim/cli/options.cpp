// SPDX-License-Identifier: MIT
#include "host_sim/cli/options.h"

#include <CLI/CLI.hpp>
#include <cmath>

namespace fixrad::host {
namespace {

CLI::Validator finite() {
  return CLI::Validator(
      [](std::string& text) {
        double value = 0;
        return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? std::string()
                                                                              : "a finite number is needed";
      },
      "NUMBER", "finite");
}

// [0, 1) for reflectances, (0, 1) for fractions.
CLI::Validator below_one(bool zero_allowed) {
  return CLI::Validator(
      [zero_allowed](std::string& text) {
        double value = -1;
        const bool ok = CLI::detail::lexical_cast(text, value) && value < 1 &&
                        (value > 0 || (zero_allowed && value == 0));
        return ok ? std::string()
                  : std::string("a number ") + (zero_allowed ? ">= 0" : "> 0") + " and < 1 is needed";
      },
      "FRACTION", "below one");
}

}  // namespace

void add_quiet(CLI::App& command, CommonOptions& options) {
  command.add_flag("--quiet", options.quiet, "Say nothing but errors");
}

void add_scene_options(CLI::App& command, CommonOptions& options) {
  command.add_option("SCENE", options.scene, "Wavefront OBJ file with its MTL")->required();
  command.add_flag("--two-sided", options.read.two_sided, "Light both sides of every face");
  command.add_flag("--flip", options.read.flip, "Turn every face round");
  command.add_option("--max-reflectance", options.read.max_reflectance, "Clamp reflectances to this")
      ->check(below_one(true));
  command
      .add_option("--exposure", options.display.exposure_ev,
                  "Stops brighter (or darker, below 0) than the automatic exposure")
      ->check(finite());
  command
      .add_option_function<std::string>(
          "--up", [&options](const std::string& axis) { options.display.z_up = axis == "z"; },
          "Axis that points up")
      ->check(CLI::IsMember({"y", "z"}))
      ->default_str("y");
  add_quiet(command, options);
}

void add_solver_options(CLI::App& command, CommonOptions& options) {
  BakeOptions& bake = options.bake;
  command
      .add_option("--profile", bake.profile,
                  "Memory that the solver may take: 6 KB, 13 KB, 60 KB, 480 KB, 64 MB")
      ->check(CLI::IsMember({"tiny", "small", "medium", "large", "host"}))
      ->capture_default_str();
  const auto choose_engine = [&options](const std::string&) { options.engine_chosen = true; };
  command
      .add_option(
          "--mesh", bake.mesh,
          "Elements: of equal size, cut where faces touch, small where the light changes, or cut along the "
          "borders of shadows")
      ->check(CLI::IsMember({"uniform", "contacts", "adaptive", "discontinuity"}))
      ->capture_default_str();
  command.add_option("--engine", bake.engine, "Form factors by")
      ->check(CLI::IsMember({"pixels", "rows", "lunes", "rays", "contour"}))
      ->each(choose_engine)
      ->capture_default_str();
  command.add_option("--solver", bake.solver, "Progressive shooting, or gathering with the full matrix")
      ->check(CLI::IsMember({"shooting", "gathering"}))
      ->capture_default_str();
  command
      .add_option("--resolution", bake.resolution,
                  "R: rows over the hemisphere for the strongest shots, 8 to 128; of a hemicube, pixels "
                  "along an edge; "
                  "of rays, 4 to 32 a pair")
      ->check(CLI::IsMember({4, 8, 16, 32, 64, 128}))
      ->each(choose_engine);
  command.parse_complete_callback([&bake] {
    if (bake.resolution && !has_resolution(bake.engine, *bake.resolution)) {
      throw CLI::ValidationError("--resolution", bake.engine == "rays"
                                                     ? "--engine rays takes 4, 8, 16 or 32 rays a pair"
                                                     : "--engine " + bake.engine + " takes 8 to 128");
    }
  });
  command.add_option("--elements", bake.elements, "At most so many elements")->check(CLI::Range(1u, 60000u));
  command
      .add_option("--unshot", bake.unshot, "Stop when the unshot flux is under this part of the emitted flux")
      ->check(below_one(false))
      ->capture_default_str();
  command
      .add_option(
          "--flux-per-row", bake.flux_per_row,
          "One row of samples for each such part of the emitted flux; less is more accurate and slower")
      ->check(below_one(false));
  command
      .add_option("--flux-per-eye", bake.flux_per_eye, "One eye point for each such part of the emitted flux")
      ->check(below_one(false));
  const auto choose = [&bake](bool overshoot) { return [&bake, overshoot] { bake.overshoot = overshoot; }; };
  command.add_flag_callback("--overshoot", choose(true), "Also shoot what the ambient estimate promises");
  command.add_flag_callback("--no-overshoot", choose(false), "Shoot unshot flux only");
  command.add_flag("--near-field", bake.near_field,
                   "Correct form factors of elements nearer than half the larger one's size");
  command.add_flag("--ambient", bake.ambient, "Add the ambient estimate of the unshot rest to the result");
}

namespace {

void add_display_edge(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--display-edge", options.display_mesh.shortest_edge,
                  "Cut no displayed edge shorter than this part of the scene's longest side; 1: show the "
                  "corners of the elements only")
      ->check(CLI::Range(1.0 / 1024, 1.0))
      ->capture_default_str();
}

}  // namespace

void add_display_options(CLI::App& command, CommonOptions& options) {
  command
      .add_option_function<std::string>(
          "--display", [&options](const std::string& how) { options.gathers_display = how == "gather"; },
          "Vertex colours by a gather at each vertex, on a mesh cut where the light bends, or by the mean of "
          "the elements round it; gather where a file shows vertices (.hpp .glb .ply .png)")
      ->check(CLI::IsMember({"gather", "mean"}));
  add_display_edge(command, options);
}

void add_state_options(CLI::App& command, CommonOptions& options) {
  StateOptions& state = options.bake.state;
  command.add_option("--resume", state.resume,
                     "Go on from this saved state of the same scene and settings, of a device too");
  CLI::Option* save = command.add_option(
      "--save", state.save, "Save the state of the solution to this file at the end, interrupted or not");
  command.add_option("--save-every", state.save_every, "Save after so many shots, too")
      ->needs(save)
      ->check(CLI::Range(1u, 1000000000u));
  command.add_option("--shots", state.shots, "End after so many shots, those before --resume included")
      ->check(CLI::Range(0u, 1000000000u));
}

void add_point_options(CLI::App& command, CommonOptions& options) {
  CLI::Option* points = command
                            .add_option("--points", options.points,
                                        "Also compare the irradiance at so many points of surfaces, from "
                                        "elements, vertex colours and gathers")
                            ->check(CLI::Range(1u, 1000000u));
  command
      .add_option("--points-truth", options.points_truth,
                  "JSON file to read the path-traced truth at the points from; written if it does not exist")
      ->needs(points);
  command
      .add_option("--points-paths", options.points_paths,
                  "Paths that are traced for the truth at each point; four times as many halve its error")
      ->check(CLI::Range(32u, 1u << 20u))
      ->capture_default_str()
      ->needs(points);
  command.add_flag("--points-only", options.points_only, "Leave out the error budget of face means")
      ->needs(points);
  add_display_edge(command, options);
}

}  // namespace fixrad::host

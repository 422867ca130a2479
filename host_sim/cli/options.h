// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/bake/bake.h"
#include "host_sim/bake/display.h"
#include "host_sim/cli/cli_app.h"
#include "host_sim/cli/picture_options.h"
#include "host_sim/io/obj_reader.h"
#include "host_sim/report/baked_mesh.h"

namespace fixrad::host {

/// Exit codes that other programs rely on.
enum ExitCode { kDone = 0, kBadInput = 1, kUsage = 2, kInterrupted = 130 };

/// What every subcommand takes.
struct CommonOptions {
  std::string scene;
  std::string state;  ///< file of a saved state
  ReadOptions read;
  BakeOptions bake;
  Display display;
  PictureChoice picture;
  bool quiet = false;
  bool keep_partial = false;
  bool engine_chosen = false;  ///< --engine or --resolution was given
  std::vector<std::string> outputs;
  std::string faces_csv;
  std::string json;
  std::string csv;
  std::uint32_t paths = 4000000;      ///< of the path-traced truth
  std::uint32_t points = 0;           ///< that compare measures irradiance at
  std::uint32_t points_paths = 4096;  ///< of the truth at each
  std::string points_truth;           ///< file of the truth there
  bool points_only = false;
  std::optional<bool> gathers_display;  ///< vertex colours by a gather, else the mean; unset: where shown
  DisplayOptions display_mesh;
};

/// Adds the scene argument and the options on reading it.
void add_scene_options(CLI::App& command, CommonOptions& options);

/// Adds the options that choose a solution.
void add_solver_options(CLI::App& command, CommonOptions& options);

/// Adds the options on saved states.
void add_state_options(CLI::App& command, CommonOptions& options);

/// Adds the options that choose how vertex colours are made.
void add_display_options(CLI::App& command, CommonOptions& options);

/// Adds the options on irradiance at points.
void add_point_options(CLI::App& command, CommonOptions& options);

/// Adds --quiet.
void add_quiet(CLI::App& command, CommonOptions& options);

/// The subcommands; each returns an ExitCode and throws InputError.
int run_bake(const CommonOptions& options);
int run_compare(const CommonOptions& options);
int run_export(const CommonOptions& options);
int run_form_factors(const CommonOptions& options);
int run_state(const CommonOptions& options);
int run_truth(const CommonOptions& options);

}  // namespace fixrad::host

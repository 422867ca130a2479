// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "host_sim/cli/cli_app.h"
#include "host_sim/report/camera.h"
#include "host_sim/report/picture.h"

namespace fixrad::host {

/// What `bake` shows in its pictures, and how.
struct PictureChoice {
  std::string show = "vertex";      ///< vertex | radiosity | mesh | error
  std::string renderer = "double";  ///< double: anti-aliased; device: the core's own pixels
  int width = 1024, height = 768;
  bool is_sized = false;         ///< --size was given
  std::optional<Camera> camera;  ///< automatic where there is none
  std::string frames;            ///< folder of the progressive sequence; empty: none

  PictureOptions options() const { return {width, height, camera}; }
};

/// Adds --camera and --size.
void add_view_options(CLI::App& command, PictureChoice& choice, const char* size_help);

/// Adds those, --show, --renderer and --frames.
void add_picture_options(CLI::App& command, PictureChoice& choice);

}  // namespace fixrad::host

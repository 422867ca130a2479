// SPDX-License-Identifier: MIT
#include "host_sim/cli/picture_options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <vector>

#include "host_sim/io/parse_number.h"

namespace fixrad::host {
namespace {

// "1,2,3" as numbers; nothing if one is none.
std::optional<std::vector<double>> numbers_in(const std::string& text, char separator) {
  std::vector<double> numbers;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t end = std::min(text.find(separator, from), text.size());
    const std::optional<double> number = parse_real(std::string_view(text).substr(from, end - from));
    if (!number || !std::isfinite(*number)) {
      return std::nullopt;
    }
    numbers.push_back(*number);
    from = end + 1;
  }
  return numbers;
}

void set_camera(const std::string& text, PictureChoice& choice) {
  const auto n = numbers_in(text, ',');
  if (!n || (n->size() != 6 && n->size() != 7)) {
    throw CLI::ValidationError("--camera",
                               "give X,Y,Z,TX,TY,TZ or X,Y,Z,TX,TY,TZ,FOV, numbers without blanks");
  }
  Camera camera;
  camera.eye = {(*n)[0], (*n)[1], (*n)[2]};
  camera.target = {(*n)[3], (*n)[4], (*n)[5]};
  camera.vertical_fov = n->size() == 7 ? (*n)[6] : camera.vertical_fov;
  if (camera.eye == camera.target || !(camera.vertical_fov > 0 && camera.vertical_fov < 180)) {
    throw CLI::ValidationError("--camera",
                               "eye and target must differ, and FOV lie between 0 and 180 degrees");
  }
  choice.camera = camera;
}

void set_size(const std::string& text, PictureChoice& choice) {
  constexpr double kLargest = 16384;
  const auto n = numbers_in(text, 'x');
  const auto is_side = [](double v) { return v >= 1 && v <= kLargest && v == std::floor(v); };
  if (!n || n->size() != 2 || !is_side((*n)[0]) || !is_side((*n)[1])) {
    throw CLI::ValidationError("--size", "give WIDTHxHEIGHT, each 1 to 16384 pixels, as in 160x120");
  }
  choice.width = static_cast<int>((*n)[0]);
  choice.height = static_cast<int>((*n)[1]);
  choice.is_sized = true;
}

}  // namespace

void add_view_options(CLI::App& command, PictureChoice& choice, const char* size_help) {
  command
      .add_option_function<std::string>(
          "--camera", [&choice](const std::string& text) { set_camera(text, choice); },
          "Where the camera stands, what it looks at, and its vertical field of view in degrees")
      ->type_name("X,Y,Z,TX,TY,TZ[,FOV]");
  command
      .add_option_function<std::string>(
          "--size", [&choice](const std::string& text) { set_size(text, choice); }, size_help)
      ->type_name("WIDTHxHEIGHT");
}

void add_picture_options(CLI::App& command, PictureChoice& choice) {
  command
      .add_option(
          "--show", choice.show,
          "What a .png shows: vertex colours, each element's radiosity, the mesh of elements, or each "
          "face's error against a path-traced truth")
      ->check(CLI::IsMember({"vertex", "radiosity", "mesh", "error"}))
      ->capture_default_str();
  add_view_options(command, choice, "Pixels of a .png [1024x768]");
  command
      .add_option("--renderer", choice.renderer,
                  "double: anti-aliased; device: the pixels that the core's renderer draws on a chip")
      ->check(CLI::IsMember({"double", "device"}))
      ->capture_default_str();
  command
      .add_option(
          "--frames", choice.frames,
          "Folder for the progressive sequence: a picture each doubling of shots, with and without the "
          "ambient estimate, and a page that shows them")
      ->type_name("DIR");
  command.final_callback([&choice] {
    if (choice.renderer == "device" && (choice.show == "mesh" || choice.show == "error")) {
      throw CLI::ValidationError("--renderer",
                                 "device shows vertex or radiosity; leave out --show " + choice.show);
    }
  });
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/io/obj_reader.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "host_sim/io/limits.h"
#include "host_sim/io/material_table.h"
#include "host_sim/io/mtl_files.h"
#include "host_sim/io/mtl_library.h"
#include "host_sim/io/obj_statements.h"
#include "host_sim/io/source_text.h"
#include "host_sim/io/text_file.h"
#include "host_sim/io/warnings.h"

namespace fixrad::host {
namespace {

void check_options(const ReadOptions& options) {
  if (options.max_reflectance && !(*options.max_reflectance >= 0.0 && *options.max_reflectance < 1.0)) {
    throw std::invalid_argument("max_reflectance must be in [0, 1)");
  }
}

void refuse_empty(const SourceText& source) {
  if (source.view().empty()) {
    throw InputError(source.path() + ": error: the file is empty; export the scene again");
  }
}

void refuse_no_faces(const Model& model) {
  if (model.faces.empty()) {
    throw InputError(model.path + ": error: the file has no faces (f); export the polygons of the scene");
  }
}

void reverse(Face& face) {
  std::reverse(face.corners.begin(), face.corners.end());
}

void orient(Model& model, const ReadOptions& options) {
  model.file_faces = model.faces.size();
  if (options.flip) {
    std::for_each(model.faces.begin(), model.faces.end(), reverse);
  }
  if (options.two_sided) {
    model.faces.reserve(2 * model.file_faces);
    for (std::size_t i = 0; i < model.file_faces; ++i) {
      reverse(model.faces.emplace_back(Face(model.faces[i])));
    }
  }
}

// Links are followed as far as they lead to a place in the OBJ file's folder.
bool is_inside(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code missing;
  const std::filesystem::path place = std::filesystem::canonical(file, missing);
  const std::filesystem::path home = std::filesystem::canonical(folder.empty() ? "." : folder, missing);
  const auto apart = std::mismatch(home.begin(), home.end(), place.begin(), place.end());
  return !missing && apart.first == home.end();
}

std::optional<std::string> load_mtl_file(const std::filesystem::path& folder, const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return std::nullopt;
  }
  if (!is_inside(folder, path)) {
    throw InputError(path + ": error: the material file lies outside the OBJ file's folder; copy it there");
  }
  return read_text_file(path, kMaxMtlBytes);
}

}  // namespace

Model read_obj_text(std::string text, const std::string& path, const LoadText& load_mtl,
                    const ReadOptions& options) {
  check_options(options);
  const SourceText source(path, std::move(text), "OBJ");
  refuse_empty(source);
  Warnings warnings;
  MtlLibrary library;
  load_mtl_files(source, load_mtl, library, warnings);
  MaterialTable materials(library, options.max_reflectance, warnings);

  Model model;
  model.path = path;
  read_obj_statements(source, model, materials, warnings);
  refuse_no_faces(model);
  materials.require_lamp(path);
  model.materials = materials.materials();
  model.warnings = warnings.lines();
  orient(model, options);
  return model;
}

Model read_obj(const std::string& path, const ReadOptions& options) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const auto load_mtl = [&](const std::string& file) { return load_mtl_file(folder, file); };
  return read_obj_text(read_text_file(path), path, load_mtl, options);
}

}  // namespace fixrad::host

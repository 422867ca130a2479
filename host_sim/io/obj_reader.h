// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "host_sim/io/model.h"

namespace fixrad::host {

/// How a scene file is to be understood.
struct ReadOptions {
  std::optional<double> max_reflectance;  ///< clamp Kd to this, in [0, 1); unset: Kd >= 1 is refused
  bool flip = false;                      ///< reverse every face, for files whose normals point outward
  bool two_sided = false;                 ///< add a reversed twin of every face, after all faces of the file
};

/// Gives the text of an MTL file, or nothing if there is none at that path.
using LoadText = std::function<std::optional<std::string>(const std::string& path)>;

/// Reads a Wavefront OBJ file and the MTL files that it names (relative to its folder).
///
/// Format: Wavefront "Object files (.obj)", appendix B1 of the Advanced Visualizer manual, as modelling tools
/// write it: polygons of 3 corners or more, negative indices, names with blanks, line continuation. Texture
/// coordinates, normals, groups, lines, points and free-form surfaces are not used. limits.h says how much of
/// it is read; MTL files lie in the folder of the OBJ file or below.
///
/// Throws InputError with the first error of the file; the MTL files count as standing at the head of it.
/// Throws std::invalid_argument if options.max_reflectance is outside [0, 1).
/// A face whose corners coincide or lie on a line is kept. Cost O(size).
Model read_obj(const std::string& path, const ReadOptions& options = {});

/// The same from memory. `path` stands in messages, and its folder in the paths that `load_mtl` gets.
Model read_obj_text(std::string text, const std::string& path, const LoadText& load_mtl,
                    const ReadOptions& options = {});

}  // namespace fixrad::host

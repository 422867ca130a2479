// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "tests/report/scratch_folder.h"

namespace fixrad::host::testing {

/// Writes OBJ text quad by quad, one line a corner and one a face.
class SceneText {
 public:
  using Corner = std::array<double, 3>;

  explicit SceneText(const std::string& mtllib = "scene.mtl") { line("mtllib " + mtllib); }

  /// A rectangle with corners o, o + a, o + a + b, o + b, lit on the side of a x b. Returns the line of its
  /// `f`.
  int quad(const std::string& material, Corner o, Corner a, Corner b);

  /// The six faces of an axis-parallel box. A room is lit inside, a body outside.
  void room(const std::string& material, Corner low, Corner high) { box(material, low, high, true); }
  void body(const std::string& material, Corner low, Corner high) { box(material, low, high, false); }

  const std::string& text() const { return text_; }

 private:
  void box(const std::string& material, Corner low, Corner high, bool lit_inside);
  void line(const std::string& words);

  std::string text_;
  int lines_ = 0;
  int corners_ = 0;
};

/// grey: Kd 0.5, white: Kd 0.7, lamp: Kd 0 and Ke 10, bulb: Kd 0 and Ke 20, glowing: Kd 1 and Ke 1 (refused
/// unless clamped).
extern const char* const kMaterials;

/// Writes scene.obj and scene.mtl into `folder`; path of the former.
std::string write_scene(const ScratchFolder& folder, const std::string& obj,
                        const std::string& mtl = kMaterials);

void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace fixrad::host::testing

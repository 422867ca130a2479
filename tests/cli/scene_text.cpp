// SPDX-License-Identifier: MIT
#include "tests/cli/scene_text.h"

#include <sstream>

namespace fixrad::host::testing {

const char* const kMaterials =
    "newmtl grey\nKd 0.5 0.5 0.5\n"
    "newmtl white\nKd 0.7 0.7 0.7\n"
    "newmtl lamp\nKd 0 0 0\nKe 10 10 10\n"
    "newmtl bulb\nKd 0 0 0\nKe 20 20 20\n"
    "newmtl glowing\nKd 1 1 1\nKe 1 1 1\n";

void SceneText::line(const std::string& words) {
  text_ += words + "\n";
  ++lines_;
}

int SceneText::quad(const std::string& material, Corner o, Corner a, Corner b) {
  for (const auto& [s, t] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
    std::ostringstream vertex;
    vertex << "v";
    for (std::size_t i = 0; i < 3; ++i) {
      vertex << ' ' << o[i] + s * a[i] + t * b[i];
    }
    line(vertex.str());
  }
  line("usemtl " + material);
  std::ostringstream face;
  face << "f " << corners_ + 1 << ' ' << corners_ + 2 << ' ' << corners_ + 3 << ' ' << corners_ + 4;
  line(face.str());
  corners_ += 4;
  return lines_;
}

void SceneText::box(const std::string& material, Corner low, Corner high, bool lit_inside) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Corner a = {}, b = {};
    a[u] = high[u] - low[u];
    b[v] = high[v] - low[v];
    Corner top = low;
    top[axis] = high[axis];
    // a x b points along +axis: into a room from its low wall, out of a body at its high one.
    quad(material, low, lit_inside ? a : b, lit_inside ? b : a);
    quad(material, top, lit_inside ? b : a, lit_inside ? a : b);
  }
}

std::string write_scene(const ScratchFolder& folder, const std::string& obj, const std::string& mtl) {
  write_file(folder / "scene.obj", obj);
  write_file(folder / "scene.mtl", mtl);
  return folder / "scene.obj";
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace fixrad::host::testing

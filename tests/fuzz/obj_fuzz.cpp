// SPDX-License-Identifier: MIT
// An OBJ text through the reader: it is refused with one line, or gives a sound model. mesh_fuzz goes on from
// there.
#include <cmath>
#include <optional>
#include <string>

#include "host_sim/io/obj_reader.h"

namespace {

const char* const kMaterials = "newmtl a\nKd 0.5 0.6 0.7\nKe 1 2 3\nnewmtl b\nKd 0.9 0.9 0.9\n";

// Half of all names are those of files.
std::optional<std::string> load_mtl(const std::string& path) {
  return path.size() % 2 == 0 ? std::nullopt : std::optional<std::string>(kMaterials);
}

bool is_sound(const fixrad::host::Model& model) {
  bool sound = !model.faces.empty() && model.file_faces <= model.faces.size();
  for (const glm::dvec3& p : model.positions) {
    sound = sound && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  for (const fixrad::host::Face& face : model.faces) {
    sound = sound && face.corners.size() >= 3 && face.material < model.materials.size();
    for (const std::uint32_t corner : face.corners) {
      sound = sound && corner < model.positions.size();
    }
  }
  return sound;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  fixrad::host::ReadOptions options;
  options.flip = size % 2 == 0;
  options.two_sided = size % 3 == 0;
  try {
    if (!is_sound(fixrad::host::read_obj_text(text, "s.obj", load_mtl, options))) {
      __builtin_trap();
    }
  } catch (const fixrad::host::InputError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) {
      __builtin_trap();
    }
  }
  return 0;
}

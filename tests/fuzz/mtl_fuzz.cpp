// SPDX-License-Identifier: MIT
// An MTL text behind a lit square whose second face uses the material that the first `newmtl` names: it is
// refused with one line, or every material is one that light can be computed with.
#include <cmath>
#include <string>

#include "host_sim/io/obj_reader.h"

namespace {

std::string first_material(const std::string& text) {
  const std::size_t at = text.find("newmtl ");
  if (at == std::string::npos) {
    return "none";
  }
  const std::size_t begin = at + 7;
  return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

void check_material(const fixrad::host::Material& material) {
  for (int c = 0; c < 3; ++c) {
    const bool is_sound = material.reflectance[c] >= 0 && material.reflectance[c] < 1 &&
                          material.emission[c] >= 0 && std::isfinite(material.emission[c]) &&
                          material.specular[c] >= 0 && material.specular[c] <= 1;
    if (!is_sound || !(material.exponent >= 0 && material.exponent <= 1000)) {
      __builtin_trap();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string obj =
      "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl " + first_material(text) + "\nf 1 2 3 4\n";
  try {
    const fixrad::host::Model model =
        fixrad::host::read_obj_text(obj, "s.obj", [&](const std::string&) { return std::optional(text); });
    for (const fixrad::host::Material& material : model.materials) {
      check_material(material);
    }
  } catch (const fixrad::host::InputError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) {
      __builtin_trap();
    }
  }
  return 0;
}

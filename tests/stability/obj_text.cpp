// SPDX-License-Identifier: MIT
#include "tests/stability/obj_text.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace fixrad::host {
namespace {

std::string line_of(const char* keyword, glm::dvec3 v) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "%s %.17g %.17g %.17g\n", keyword, v.x, v.y, v.z);
  return text.data();
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    throw std::runtime_error("cannot write " + path);
  }
}

}  // namespace

std::string obj_text(const Model& model, const std::string& library) {
  std::string text = "mtllib " + library + "\n";
  for (const glm::dvec3& p : model.positions) {
    text += line_of("v", p);
  }
  for (const Face& face : model.faces) {
    text += "usemtl " + model.materials[face.material].name + "\nf";
    for (const std::uint32_t v : face.corners) {
      text += " " + std::to_string(v + 1);
    }
    text += "\n";
  }
  return text;
}

std::string mtl_text(const Model& model) {
  std::string text;
  for (const Material& material : model.materials) {
    text += "newmtl " + material.name + "\n" + line_of("Kd", material.reflectance);
    if (material.emission != glm::dvec3(0.0)) {
      text += line_of("Ke", material.emission);
    }
  }
  return text;
}

std::string write_obj(const Model& model, const std::string& folder, const std::string& name) {
  write(folder + "/" + name + ".mtl", mtl_text(model));
  write(folder + "/" + name + ".obj", obj_text(model, name + ".mtl"));
  return folder + "/" + name + ".obj";
}

}  // namespace fixrad::host

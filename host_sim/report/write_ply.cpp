// SPDX-License-Identifier: MIT
#include <string>

#include "host_sim/report/mesh_check.h"
#include "host_sim/report/text.h"
#include "host_sim/report/tone.h"
#include "host_sim/report/writers.h"

namespace fixrad::host {
namespace {

void append_header(std::string& text, const BakedMesh& mesh, const Display& display, double scale) {
  text += "ply\nformat ascii 1.0\ncomment fixrad vertex lighting of " + one_line(mesh.name);
  text += "\ncomment B_r B_g B_b: radiosity, linear, W/m^2 (the unit of MTL Ke)";
  text += "\ncomment red green blue: 8-bit sRGB of tone(B * exposure), exposure ";
  append_number(text, scale);
  text += ", EV ";
  append_number(text, display.exposure_ev);
  text += "\nelement vertex ";
  append_number(text, static_cast<std::int64_t>(mesh.positions.size()));
  for (const char* property :
       {"float x", "float y", "float z", "float nx", "float ny", "float nz", "uchar red", "uchar green",
        "uchar blue", "float B_r", "float B_g", "float B_b"}) {
    text += "\nproperty ";
    text += property;
  }
  text += "\nelement face ";
  append_number(text, static_cast<std::int64_t>(mesh.triangles.size()));
  text += "\nproperty list uchar int vertex_indices\nend_header\n";
}

void append_floats(std::string& text, const glm::dvec3& v) {
  for (int k = 0; k < 3; ++k) {
    append_number(text, finite_float(v[k]));
    text += k == 2 ? "" : " ";
  }
}

}  // namespace

void write_ply(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display) {
  check_mesh(mesh);
  const double scale = exposure_scale(mesh, display);
  std::string text;
  append_header(text, mesh, display, scale);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append_floats(text, mesh.positions[i]);
    text += ' ';
    append_floats(text, mesh.normals[i]);
    for (const std::uint8_t channel : display_colour(mesh.radiosity[i], scale)) {
      text += ' ';
      append_number(text, std::int64_t{channel});
    }
    text += ' ';
    append_floats(text, mesh.radiosity[i]);
    text += '\n';
  }
  for (const auto& triangle : mesh.triangles) {
    text += '3';
    for (const std::uint32_t corner : triangle) {
      text += ' ';
      append_number(text, std::int64_t{corner});
    }
    text += '\n';
  }
  write_text(target, text);
}

}  // namespace fixrad::host

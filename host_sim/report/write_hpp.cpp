// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "host_sim/report/flash_encoding.h"
#include "host_sim/report/mesh_check.h"
#include "host_sim/report/text.h"
#include "host_sim/report/tone.h"
#include "host_sim/report/writers.h"

namespace fixrad::host {
namespace {

constexpr std::size_t kRowsPerLine = 4;

std::string include_guard(const std::string& identifier) {
  std::string guard = "FIXRAD_TABLE_" + identifier + "_HPP";
  std::transform(guard.begin(), guard.end(), guard.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return guard;
}

/// `{1, 2, 3}`
template <typename Row>
void append_row(std::string& text, const Row& row) {
  text += '{';
  for (std::size_t k = 0; k < row.size(); ++k) {
    text += k == 0 ? "" : ", ";
    append_number(text, static_cast<std::int64_t>(row[k]));
  }
  text += '}';
}

/// A two-dimensional table, `row_of(i)` an array of integers for each of `count` rows.
template <typename RowOf>
void append_table(std::string& text, const std::string& declaration, std::size_t count, RowOf row_of) {
  text += "constexpr " + declaration + " FIXRAD_FLASH = {";
  for (std::size_t i = 0; i < count; ++i) {
    text += i % kRowsPerLine == 0 ? "\n    " : " ";
    append_row(text, row_of(i));
    text += ',';
  }
  text += "\n};\n";
}

void append_constant(std::string& text, const std::string& declaration, double value) {
  text += "constexpr float " + declaration + " = ";
  append_float_literal(text, finite_float(value));
  text += ";\n";
}

void append_head(std::string& text, const BakedMesh& mesh, const std::string& identifier) {
  const std::string guard = include_guard(identifier);
  text +=
      "// Vertex lighting of " + one_line(mesh.name) + ", made by fixrad. Bake again instead of editing.\n";
  text +=
      "// Needs C++11 and <stdint.h> only. Define FIXRAD_FLASH before the #include as the attribute that "
      "keeps\n"
      "// the tables in flash where the compiler would not by itself, for instance PROGMEM on AVR.\n";
  text += "#ifndef " + guard + "\n#define " + guard + "\n\n#include <stdint.h>\n\n";
  text += "#ifndef FIXRAD_FLASH\n#define FIXRAD_FLASH\n#endif\n\nnamespace " + identifier + " {\n\n";
}

void append_counts(std::string& text, const BakedMesh& mesh) {
  text += "constexpr uint32_t vertex_count = " + std::to_string(mesh.positions.size()) + ";\n";
  text += "constexpr uint32_t triangle_count = " + std::to_string(mesh.triangles.size()) + ";\n\n";
}

void append_positions(std::string& text, const BakedMesh& mesh) {
  const PositionGrid grid = position_grid(mesh.positions);
  text +=
      "// Position k of vertex i is position_offset[k] + positions[i][k] * position_scale, in the scene's "
      "unit,\n"
      "// within position_scale / 2.\n";
  append_constant(text, "position_scale", grid.scale);
  text += "constexpr float position_offset[3] = {";
  for (int k = 0; k < 3; ++k) {
    text += k == 0 ? "" : ", ";
    append_float_literal(text, finite_float(grid.offset[k]));
  }
  text += "};\n";
  append_table(text, "int16_t positions[vertex_count][3]", mesh.positions.size(),
               [&](std::size_t i) { return quantise(grid, mesh.positions[i]); });
}

void append_colours(std::string& text, const BakedMesh& mesh, const Display& display) {
  const double scale = exposure_scale(mesh, display);
  text +=
      "\n// Display colour: red, green, blue, 8-bit sRGB of tone(radiosity * exposure), rounded to nearest.\n"
      "// exposure is the automatic one times 2^exposure_ev; tone() is a curve with a soft shoulder to "
      "white.\n";
  append_constant(text, "exposure", scale);
  append_constant(text, "exposure_ev", display.exposure_ev);
  append_table(text, "uint8_t colors[vertex_count][3]", mesh.positions.size(),
               [&](std::size_t i) { return display_colour(mesh.radiosity[i], scale); });
}

void append_radiosity(std::string& text, const BakedMesh& mesh) {
  text +=
      "\n// Radiosity, linear, W/m^2, as RGBE8: {red, green, blue, e}. A channel m with e > 0 is\n"
      "// m * 2^(e - radiosity_bias), within half of 2^(e - radiosity_bias); e = 0 is black.\n";
  text += "constexpr int radiosity_bias = " + std::to_string(kRgbeBias) + ";\n";
  append_table(text, "uint8_t radiosity[vertex_count][4]", mesh.positions.size(),
               [&](std::size_t i) { return rgbe8(mesh.radiosity[i]); });
}

void append_triangles(std::string& text, const BakedMesh& mesh) {
  const char* type = mesh.positions.size() <= 0x10000 ? "uint16_t" : "uint32_t";
  text += "\n// Vertices of a triangle, counter-clockwise seen from the lit side.\n";
  append_table(text, std::string(type) + " triangles[triangle_count][3]", mesh.triangles.size(),
               [&](std::size_t i) { return mesh.triangles[i]; });
}

}  // namespace

void write_hpp(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display) {
  check_mesh(mesh);
  const std::string identifier = namespace_name(mesh.name);
  std::string text;
  append_head(text, mesh, identifier);
  append_counts(text, mesh);
  append_positions(text, mesh);
  append_colours(text, mesh, display);
  append_radiosity(text, mesh);
  append_triangles(text, mesh);
  text += "\n}  // namespace " + identifier + "\n\n#endif  // " + include_guard(identifier) + "\n";
  write_text(target, text);
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/report/write_scene.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "host_sim/report/flash_encoding.h"
#include "host_sim/report/table_text.h"
#include "host_sim/report/text.h"
#include "host_sim/report/write_picture.h"

namespace fixrad::host {
namespace {

std::string record_of(std::uint16_t value) {
  return literal(value);
}
std::string record_of(std::int32_t value) {
  return literal(value);
}
std::string record_of(const Vertex& v) {
  return braced({literal(v.x), literal(v.y), literal(v.z)});
}
std::string record_of(const fixrad::Face& f) {
  return braced({literal(f.first_corner), literal(f.material), literal(f.first_cell_row),
                 literal(f.corner_count), literal(f.cells_u), literal(f.cells_v), braced_array(f.normal),
                 braced_array(f.tangent), braced_array(f.origin), braced_array(f.axis_u),
                 braced_array(f.axis_v), unsigned_literal(f.cell_area), literal(f.is_sealed)});
}
std::string record_of(const CellRow& r) {
  return braced({literal(r.first_element), literal(r.first_cell), literal(r.last_cell)});
}
std::string record_of(const Cut& c) {
  return braced({literal(c.a), literal(c.b), literal(c.c), literal(c.left), literal(c.right)});
}
std::string record_of(const Element& e) {
  return braced({unsigned_literal(e.area), braced_array(e.eye), literal(e.patch), literal(e.face),
                 literal(e.material)});
}
std::string record_of(Sight sight) {
  switch (sight) {
    case Sight::centroid_clear:
      return "fixrad::Sight::centroid_clear";
    case Sight::centroid_buried:
      return "fixrad::Sight::centroid_buried";
    case Sight::all_clear:
      return "fixrad::Sight::all_clear";
    case Sight::unknown:
      break;
  }
  return "fixrad::Sight::unknown";
}
std::string record_of(const Patch& p) {
  return braced({literal(p.face), literal(p.first_element), literal(p.element_count)});
}
std::string record_of(const fixrad::Material& m) {
  std::vector<std::string> reflectance, emission;
  for (int c = 0; c < kMaxChannels; ++c) {
    reflectance.push_back(unsigned_literal(m.reflectance[c]));
    emission.push_back(unsigned_literal(m.emission[c]));
  }
  return braced({braced(reflectance), braced(emission)});
}
std::string record_of(const MeshVertex& v) {
  return braced({unsigned_literal(v.first), unsigned_literal(v.inner), literal(v.count)});
}
std::string record_of(const Ledger& l) {
  return braced(
      {literal(l.emitted), literal(l.absorbed), literal(l.unshot), literal(l.escaped), literal(l.back)});
}

template <class T>
void append_records(std::string& text, std::string_view declaration, const T* records, std::size_t count) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < count; ++i) {
    lines.push_back(record_of(records[i]));
  }
  append_table(text, declaration, lines);
}

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

constexpr char kPictureIncludes[] =
    "#include \"lib/picture/draw.h\"\n#include \"lib/picture/highlight.h\"\n#include "
    "\"lib/picture/tone.h\"\n";

void append_head(std::string& text, const SceneTable& table, const std::string& name) {
  const Scene& s = table.scene;
  text +=
      "// SPDX-License-Identifier: MIT\n"
      "// clang-format off\n"
      "// The scene of " +
      one_line(table.source) + " for profile " + one_line(table.profile) + " (" + one_line(table.chip) +
      "), and what its solution must be.\n"
      "// Made by `fixrad export`: export again instead of editing.\n"
      "// " +
      literal(s.face_count) + " faces, " + literal(s.element_count) + " elements, " + literal(s.patch_count) +
      " patches, " + literal(table.map.vertex_count) + " vertices of the displayed mesh, " +
      literal(s.channels) + (s.channels == 1 ? " channel" : " channels") +
      ".\n"
      "// One unit of flux: " +
      number(table.unit_watts) + " W. One unit of radiosity: " + number(table.unit_radiosity) +
      " W/m^2.\n"
      "#pragma once\n\n"
      "#include <stdint.h>\n\n"
      "#include \"lib/fixrad.h\"\n" +
      std::string(table.picture ? kPictureIncludes : "") + "\nnamespace " + name + " {\n\n";
}

std::size_t map_elements(const VertexMap& map) {
  std::size_t end = 0;
  for (std::uint32_t v = 0; v < map.vertex_count; ++v) {
    end = std::max(end, std::size_t{map.vertices[v].first} + map.vertices[v].count);
  }
  return end;
}

void append_scene_tables(std::string& text, const SceneTable& table) {
  const Scene& s = table.scene;
  append_records(text, "fixrad::Vertex kVertices[]", s.vertices, s.vertex_count);
  append_records(text, "uint16_t kCorners[]", s.corners, s.corner_count);
  append_records(text, "fixrad::Face kFaces[]", s.faces, s.face_count);
  append_records(text, "fixrad::CellRow kCellRows[]", s.cell_rows, s.cell_row_count);
  if (s.roots != nullptr) {
    append_records(text, "uint16_t kRoots[]", s.roots, s.root_count);
    append_records(text, "fixrad::Cut kCuts[]", s.cuts, s.cut_count);
  }
  append_records(text, "fixrad::Element kElements[]", s.elements, s.element_count);
  append_records(text, "fixrad::Patch kPatches[]", s.patches, s.patch_count);
  append_records(text, "uint16_t kPatchElements[]", s.patch_elements, s.element_count);
  append_records(text, "fixrad::Material kMaterials[]", s.materials, s.material_count);
  if (s.sights != nullptr) {
    append_records(text, "fixrad::Sight kSights[]", s.sights, s.element_count);
  }
  append_records(text, "fixrad::MeshVertex kMeshVertices[]", table.map.vertices, table.map.vertex_count);
  append_records(text, "uint16_t kMeshVertexElements[]", table.map.elements, map_elements(table.map));
}

const char* engine_name(Engine engine) {
  constexpr std::pair<Engine, const char*> kNames[] = {{hemicube_rows, "fixrad::hemicube_rows"},
                                                       {hemicube_pixels, "fixrad::hemicube_pixels"},
                                                       {lune_rows, "fixrad::lune_rows"},
                                                       {ray_row, "fixrad::ray_row"},
                                                       {contour_row, "fixrad::contour_row"}};
  const auto* known = std::find_if(std::begin(kNames), std::end(kNames),
                                   [engine](const auto& name) { return name.first == engine; });
  if (known == std::end(kNames)) {
    throw std::invalid_argument("only the core's own engines have a name");
  }
  return known->second;
}

std::string table_name(const DeltaTable* table) {
  return table->cosine != nullptr ? "fixrad::kLunes + " + literal(table - kLunes)
                                  : "&fixrad::kDelta" + literal(1 << table->resolution_log2);
}

void append_scene_function(std::string& text, const Scene& s) {
  append_function(text, "Scene", "scene",
                  {{"vertices", "kVertices"},
                   {"corners", "kCorners"},
                   {"faces", "kFaces"},
                   {"cell_rows", "kCellRows"},
                   {"roots", s.roots != nullptr ? "kRoots" : "nullptr"},
                   {"cuts", s.roots != nullptr ? "kCuts" : "nullptr"},
                   {"elements", "kElements"},
                   {"patches", "kPatches"},
                   {"patch_elements", "kPatchElements"},
                   {"materials", "kMaterials"},
                   {"sights", s.sights != nullptr ? "kSights" : "nullptr"},
                   {"vertex_count", literal(s.vertex_count)},
                   {"corner_count", literal(s.corner_count)},
                   {"face_count", literal(s.face_count)},
                   {"cell_row_count", literal(s.cell_row_count)},
                   {"root_count", literal(s.root_count)},
                   {"cut_count", literal(s.cut_count)},
                   {"element_count", literal(s.element_count)},
                   {"patch_count", literal(s.patch_count)},
                   {"material_count", literal(s.material_count)},
                   {"channels", literal(s.channels)},
                   {"emission_shift", literal(s.emission_shift)},
                   {"radiosity_shift", literal(s.radiosity_shift)}});
}

void append_vertex_map_function(std::string& text, const VertexMap& map) {
  append_function(text, "VertexMap", "vertex_map",
                  {{"vertices", "kMeshVertices"},
                   {"elements", "kMeshVertexElements"},
                   {"vertex_count", literal(map.vertex_count)}});
}

// Takes Settings apart so that a member which is added to it does not compile until it is written here too.
void append_settings_function(std::string& text, const Settings& settings) {
  const auto& [engine, tables, table_count, probe, stop, flux_per_row, flux_per_eye, overshoot, near_field,
               observer] = settings;
  const auto fraction_of = [](Fraction f) {
    return "fixrad::Fraction::from_raw(" + unsigned_literal(f.raw) + ")";
  };
  std::vector<std::pair<const char*, std::string>> members = {{"engine", engine_name(engine)},
                                                              {"tables", table_name(tables)},
                                                              {"table_count", literal(table_count)},
                                                              {"probe", table_name(probe)},
                                                              {"stop", fraction_of(stop)},
                                                              {"flux_per_row", fraction_of(flux_per_row)},
                                                              {"flux_per_eye", fraction_of(flux_per_eye)},
                                                              {"overshoot", overshoot ? "true" : "false"}};
  if (near_field != nullptr) {
    members.emplace_back("near_field", "fixrad::correct_near_field");
  }
  append_function(text, "Settings", "settings", members);
}

void append_solver(std::string& text, const Sizes& s) {
  text += "\n// Vertices, faces, elements, spans, channels, resolution of the item buffer.\n";
  text += "using Limits = fixrad::Limits<";
  for (const std::uint32_t size : {s.vertices, s.faces, s.elements, s.spans, s.channels}) {
    text += literal(size) + ", ";
  }
  text += literal(s.pixel_resolution) + ">;\nusing Solver = fixrad::Solver<Limits>;\n";
}

void append_expected(std::string& text, const SceneTable& table) {
  text += "\nnamespace expected {\n\n";
  text += "constexpr uint64_t kDigest = " + hex_literal(table.digest) + ";\n";
  text += "constexpr uint32_t kShots = " + unsigned_literal(table.shots) + ";\n";
  text += "constexpr uint32_t kEyes = " + unsigned_literal(table.eyes) + ";\n";
  text += "// A line a channel: emitted, absorbed, unshot, escaped, back; units of flux.\n";
  append_records(text, "int64_t kLedger[][5]", table.ledger.data(), table.ledger.size());
  text += "// [element][channel], units of flux.\n";
  append_records(text, "int32_t kReceived[]", table.received.data(), table.received.size());
  if (table.picture) {
    text += "// Of the pixels, from the top, FNV-1a.\nconstexpr uint64_t kPictureDigest = " +
            hex_literal(table.picture_digest) + ";\n";
  }
  text += "\n}  // namespace expected\n";
}

// The core's own namespace holds names that a scene's has too.
std::string scene_namespace(const std::filesystem::path& target) {
  const std::string name = namespace_name(target.stem().string());
  return name == "fixrad" ? "scene_fixrad" : name;
}

}  // namespace

void write_scene(const std::filesystem::path& target, const SceneTable& table) {
  const std::string name = scene_namespace(target);
  std::string text;
  append_head(text, table, name);
  append_scene_tables(text, table);
  append_scene_function(text, table.scene);
  append_vertex_map_function(text, table.map);
  append_settings_function(text, table.settings);
  append_solver(text, table.sizes);
  if (table.picture) {
    append_picture(text, *table.picture);
  }
  append_expected(text, table);
  text += "\n}  // namespace " + name + "\n";
  write_text(target, text);
}

}  // namespace fixrad::host

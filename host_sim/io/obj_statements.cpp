// SPDX-License-Identifier: MIT
#include "host_sim/io/obj_statements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "host_sim/io/limits.h"
#include "host_sim/io/parse_number.h"

namespace fixrad::host {
namespace {

constexpr std::size_t kCoordinates = 3;

/// Statements without influence on polygons and their materials.
constexpr std::string_view kIgnored[] = {"mtllib", "vt",         "vn",        "vp",       "o",    "g",
                                         "mg",     "bevel",      "c_interp",  "d_interp", "lod",  "maplib",
                                         "usemap", "shadow_obj", "trace_obj", "cstype",   "deg",  "bmat",
                                         "step",   "parm",       "trim",      "hole",     "scrv", "sp",
                                         "end",    "con",        "ctech",     "stech"};

constexpr std::string_view kUnusedGeometry[] = {"l", "p", "curv", "curv2", "surf"};

template <typename Range>
bool contains(const Range& range, std::string_view keyword) {
  return std::find(std::begin(range), std::end(range), keyword) != std::end(range);
}

std::string at_most(std::size_t most, const char* what) {
  return std::string("the file has more than ") + std::to_string(most) + " " + what +
         "; no device holds as many, simplify the scene";
}

std::size_t count_vertices(const SourceText& source) {
  StatementReader reader(source);
  Statement statement;
  std::size_t count = 0;
  while (reader.next(statement)) {
    count += statement.keyword == "v" ? 1U : 0U;
    if (count > kMaxVertices) {
      source.fail(statement.keyword, at_most(kMaxVertices, "vertices"));
    }
  }
  return count;
}

class ObjParser {
 public:
  ObjParser(const SourceText& source, Model& model, MaterialTable& materials, Warnings& warnings)
      : source_(source),
        model_(model),
        materials_(materials),
        warnings_(warnings),
        vertex_count_(count_vertices(source)) {}

  void read();

 private:
  void read_statement(const Statement& statement);
  void read_vertex(const Statement& statement);
  void read_face(const Statement& statement);
  void read_smoothing_group(const Statement& statement);
  void skip(const Statement& statement);
  std::uint32_t read_corner(std::string_view token) const;
  std::uint32_t resolve(std::int64_t index, std::string_view token) const;
  void refuse_repeated_corner(const Statement& statement, const std::vector<std::uint32_t>& corners) const;
  std::uint32_t current_material(const Statement& face);

  const SourceText& source_;
  Model& model_;
  MaterialTable& materials_;
  Warnings& warnings_;
  std::size_t vertex_count_;
  std::size_t corner_count_ = 0;
  std::string material_name_;
  std::string_view usemtl_;  // the keyword that material_name_ comes from; empty before the first
  std::optional<std::uint32_t> material_;
  std::uint32_t smoothing_group_ = 0;
};

void ObjParser::read() {
  model_.positions.reserve(vertex_count_);
  StatementReader reader(source_);
  Statement statement;
  while (reader.next(statement)) {
    read_statement(statement);
  }
}

void ObjParser::read_statement(const Statement& statement) {
  if (statement.keyword == "v") {
    read_vertex(statement);
  } else if (statement.keyword == "f" || statement.keyword == "fo") {
    read_face(statement);  // fo is the old name of f
  } else if (statement.keyword == "usemtl") {
    material_name_ = statement.name();
    usemtl_ = statement.arguments.empty() ? statement.keyword : statement.arguments.front();
    material_.reset();
  } else if (statement.keyword == "s") {
    read_smoothing_group(statement);
  } else {
    skip(statement);
  }
}

void ObjParser::read_vertex(const Statement& statement) {
  const std::size_t count = statement.arguments.size();
  // x y z, then a weight w, a colour r g b, or both
  if (count != 3 && count != 4 && count != 6 && count != 7) {
    source_.fail(statement.keyword, "the vertex has " + std::to_string(count) + " numbers; give x y z");
  }
  glm::dvec3 position(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view token = statement.arguments[i];
    const std::optional<double> value = parse_real(token);
    if (!value) {
      source_.fail(token, explain_bad_number(token));
    }
    if (!std::isfinite(*value)) {
      source_.fail(token, "the coordinate " + quote(token) + " is not a finite number; correct the vertex");
    }
    if (std::abs(*value) > kMaxCoordinate) {
      source_.fail(token, "the coordinate " + quote(token) + " is beyond 1e30; scale the scene down");
    }
    if (i < kCoordinates) {
      position[static_cast<glm::dvec3::length_type>(i)] = *value;
    }
  }
  model_.positions.push_back(position);
}

void ObjParser::read_face(const Statement& statement) {
  const std::size_t count = statement.arguments.size();
  if (count < 3) {
    source_.fail(statement.keyword, "the face has " + std::to_string(count) +
                                        (count == 1 ? " corner" : " corners") +
                                        "; give it 3 or more, or delete it");
  }
  if (count > kMaxFaceCorners) {
    source_.fail(statement.keyword,
                 "the face has more than " + std::to_string(kMaxFaceCorners) + " corners; split it");
  }
  if (model_.faces.size() == kMaxFaces) {
    source_.fail(statement.keyword, at_most(kMaxFaces, "faces"));
  }
  corner_count_ += count;
  if (corner_count_ > kMaxFileCorners) {
    source_.fail(statement.keyword, at_most(kMaxFileCorners, "corners of faces"));
  }
  Face face;
  face.corners.reserve(count);
  for (const std::string_view token : statement.arguments) {
    face.corners.push_back(read_corner(token));
  }
  refuse_repeated_corner(statement, face.corners);
  face.material = current_material(statement);
  face.smoothing_group = smoothing_group_;
  face.line = statement.line;
  model_.faces.push_back(std::move(face));
}

/// v, v/vt, v//vn or v/vt/vn; only v is used, but the others must be integers where they are given.
std::uint32_t ObjParser::read_corner(std::string_view token) const {
  const auto refuse = [&] {
    source_.fail(token, quote(token) + " is not a corner; write v, v/vt, v//vn or v/vt/vn, each an integer");
  };
  std::optional<std::int64_t> vertex;
  std::string_view remaining = token;
  for (int field = 0;; ++field) {
    const std::size_t slash = remaining.find('/');
    const std::string_view text = remaining.substr(0, slash);
    const std::optional<std::int64_t> index = parse_integer(text);
    const bool may_be_empty = field > 0;
    if (field > 2 || (!index && !(may_be_empty && text.empty()))) {
      refuse();
    }
    vertex = field == 0 ? index : vertex;
    if (slash == std::string_view::npos) {
      return resolve(*vertex, token);
    }
    remaining.remove_prefix(slash + 1);
  }
}

std::uint32_t ObjParser::resolve(std::int64_t index, std::string_view token) const {
  const auto above = static_cast<std::int64_t>(model_.positions.size());
  if (index > 0 && index <= static_cast<std::int64_t>(vertex_count_)) {
    return static_cast<std::uint32_t>(index - 1);
  }
  if (index < 0 && index >= -above) {
    return static_cast<std::uint32_t>(above + index);
  }
  if (index == 0) {
    source_.fail(token, "a corner has vertex 0; vertices count from 1");
  }
  source_.fail(token, "there is no vertex " + quote(token) + "; the file has " +
                          (index > 0 ? std::to_string(vertex_count_) + " vertices"
                                     : std::to_string(above) + " vertices above this line") +
                          ", correct the index");
}

void ObjParser::refuse_repeated_corner(const Statement& statement,
                                       const std::vector<std::uint32_t>& corners) const {
  std::vector<std::pair<std::uint32_t, std::size_t>> sorted;
  sorted.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sorted.emplace_back(corners[i], i);
  }
  std::sort(sorted.begin(), sorted.end());
  std::size_t repeated = corners.size();  // the first corner in file order that stands further left already
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) {
      repeated = std::min(repeated, sorted[i].second);
    }
  }
  if (repeated < corners.size()) {
    const std::string_view token = statement.arguments[repeated];
    source_.fail(token, "the face has vertex " + std::to_string(corners[repeated] + 1) +
                            " twice; delete the repeated corner or the face");
  }
}

/// Materials are looked up by the first face, so that a usemtl without faces may name anything.
std::uint32_t ObjParser::current_material(const Statement& face) {
  if (!material_) {
    material_ = materials_.use(material_name_, source_, usemtl_.empty() ? face.keyword : usemtl_);
  }
  return *material_;
}

void ObjParser::read_smoothing_group(const Statement& statement) {
  const std::string_view token = statement.arguments.empty() ? "off" : statement.arguments.front();
  const std::optional<std::int64_t> group = token == "off" ? 0 : parse_integer(token);
  const bool is_valid = group && *group >= 0 && *group <= std::numeric_limits<std::uint32_t>::max();
  smoothing_group_ = is_valid ? static_cast<std::uint32_t>(*group) : 0U;
  if (!is_valid) {
    warnings_.say_once("bad s", source_, token,
                       "the smoothing group " + quote(token) + " is no number; taken as off");
  }
}

void ObjParser::skip(const Statement& statement) {
  const std::string keyword(statement.keyword);
  if (contains(kUnusedGeometry, keyword)) {
    warnings_.say_once("OBJ statement " + keyword, source_, statement.keyword,
                       "points, lines, curves and free-form surfaces (" + quote(keyword) + ") are ignored");
  } else if (!contains(kIgnored, keyword)) {
    warnings_.say_once("OBJ statement " + keyword, source_, statement.keyword,
                       "the OBJ statement " + quote(keyword) + " is not known and is ignored");
  }
}

}  // namespace

void read_obj_statements(const SourceText& source, Model& model, MaterialTable& materials,
                         Warnings& warnings) {
  ObjParser(source, model, materials, warnings).read();
}

}  // namespace fixrad::host

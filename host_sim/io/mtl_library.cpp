// SPDX-License-Identifier: MIT
#include "host_sim/io/mtl_library.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "host_sim/io/limits.h"
#include "host_sim/io/parse_number.h"

namespace fixrad::host {
namespace {

/// Statements that say nothing about diffuse reflection or emission.
constexpr std::string_view kIgnored[] = {
    "Ka",       "Ni",      "Tf",     "Tr",       "d",      "sharpness",   "map_Ka",    "map_Ks",
    "map_Ns",   "map_Ni",  "map_Tf", "map_Tr",   "map_d",  "map_opacity", "map_aat",   "map_bump",
    "map_Bump", "bump",    "disp",   "map_disp", "decal",  "refl",        "map_refl",  "norm",
    "map_norm", "map_Kn",  "Pr",     "Pm",       "Ps",     "Pc",          "Pcr",       "aniso",
    "anisor",   "map_Pr",  "map_Pm", "map_Ps",   "map_Pc", "map_Pcr",     "map_aniso", "Km",
    "map_RMA",  "map_ORM", "Pe",     "map_Pe",   "it",     "fresnel"};

bool is_ignored(std::string_view keyword) {
  return std::find(std::begin(kIgnored), std::end(kIgnored), keyword) != std::end(kIgnored);
}

/// `Kd r g b`, or `Kd r` for grey (the specification makes g and b optional).
MtlColor parse_color(const SourceText& source, const Statement& statement) {
  const std::vector<std::string_view>& arguments = statement.arguments;
  MtlColor color;
  color.given = true;
  if (!arguments.empty() && (arguments[0] == "spectral" || arguments[0] == "xyz")) {
    color.unsupported = arguments[0];
    return color;
  }
  if (arguments.size() != 1 && arguments.size() != 3) {
    source.fail(statement.keyword, std::string(statement.keyword) + " has " +
                                       std::to_string(arguments.size()) +
                                       " numbers; give three (red green blue) or one");
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::string_view token = arguments.size() == 3 ? arguments[channel] : arguments[0];
    const std::optional<double> value = parse_real(token);
    if (!value) {
      source.fail(token, explain_bad_number(token));
    }
    color.tokens[channel] = token;
    color.value[static_cast<glm::dvec3::length_type>(channel)] = *value;
  }
  return color;
}

bool belongs_to_material(std::string_view keyword) {
  return keyword == "Kd" || keyword == "Ke" || keyword == "map_Kd" || keyword == "map_Ke" ||
         keyword == "Ks" || keyword == "Ns" || keyword == "illum";
}

void read_into(const SourceText& source, const Statement& statement, MtlMaterial& material) {
  if (statement.keyword == "Kd") {
    material.reflectance = parse_color(source, statement);
  } else if (statement.keyword == "Ke") {
    material.emission = parse_color(source, statement);
  } else if (statement.keyword == "Ks") {
    material.specular = statement;
  } else if (statement.keyword == "Ns") {
    material.exponent = statement;
  } else if (statement.keyword == "illum") {
    material.illumination = statement;
  } else if (statement.keyword == "map_Kd") {
    material.map_kd = statement.keyword;
  } else {
    material.map_ke = statement.keyword;
  }
}

}  // namespace

MtlMaterial* MtlLibrary::open(const SourceText& source, const Statement& statement, Warnings& warnings) {
  MtlMaterial material;
  material.name = statement.name();
  material.source = &source;
  material.statement = statement.keyword;
  if (material.name.empty()) {
    source.fail(statement.keyword, "newmtl has no name; name the material");
  }
  const auto [entry, is_new] = by_name_.try_emplace(material.name, materials_.size());
  if (materials_.size() == kMaxMaterials && is_new) {
    source.fail(statement.keyword, "the MTL files define more than " + std::to_string(kMaxMaterials) +
                                       " materials; leave out those that no face uses");
  }
  if (is_new) {
    materials_.push_back(std::move(material));
  } else {
    warnings.say_once("duplicate " + material.name, source, statement.keyword,
                      "the material " + quote(material.name) + " is defined again; this definition is used");
    materials_[entry->second] = std::move(material);
  }
  return &materials_[entry->second];
}

void MtlLibrary::load(const std::string& path, std::string text, Warnings& warnings) {
  const SourceText& source = sources_.emplace_back(path, std::move(text), "MTL");
  StatementReader reader(source);
  Statement statement;
  MtlMaterial* material = nullptr;
  while (reader.next(statement)) {
    const std::string keyword(statement.keyword);
    if (keyword == "newmtl") {
      material = open(source, statement, warnings);
    } else if (belongs_to_material(keyword)) {
      if (material == nullptr) {
        source.fail(statement.keyword, keyword + " stands before the first newmtl; put it below one");
      }
      read_into(source, statement, *material);
    } else if (!is_ignored(keyword)) {
      warnings.say_once("MTL statement " + keyword, source, statement.keyword,
                        "the MTL statement " + quote(keyword) + " is not known and is ignored");
    }
  }
}

const MtlMaterial* MtlLibrary::find(const std::string& name) const {
  const auto entry = by_name_.find(name);
  return entry == by_name_.end() ? nullptr : &materials_[entry->second];
}

}  // namespace fixrad::host

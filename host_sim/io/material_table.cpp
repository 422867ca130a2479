// SPDX-License-Identifier: MIT
#include "host_sim/io/material_table.h"

#include <algorithm>
#include <cmath>

#include "host_sim/io/limits.h"
#include "host_sim/io/parse_number.h"

namespace fixrad::host {
namespace {

constexpr double kDefaultReflectance = 0.5;
constexpr std::size_t kMaxNamesListed = 8;
constexpr double kMaxExponent = 1000.0;  // of the MTL specification

// Illumination models of the MTL specification: 2 and above have highlights, 3 and 5 reflect like a mirror.
constexpr double kHighlightModel = 2;
constexpr double kMaxModel = 10;

bool is_mirror_model(double model) {
  return model == 3 || model == 5;
}

/// A number of `statement` within [0, most].
double checked_number(const SourceText& source, const Statement& statement, std::string_view token,
                      double most) {
  const std::optional<double> value = parse_real(token);
  if (!value) {
    source.fail(token, explain_bad_number(token));
  }
  if (!(*value >= 0.0 && *value <= most)) {
    source.fail(token, std::string(statement.keyword) + " is " + quote(token) + "; give 0 to " +
                           std::to_string(static_cast<int>(most)));
  }
  return *value;
}

/// The only number of `statement`; 0 where it is not given.
double single_number(const SourceText& source, const Statement& statement, double most) {
  if (statement.keyword.empty()) {
    return 0.0;
  }
  if (statement.arguments.size() != 1) {
    source.fail(statement.keyword, std::string(statement.keyword) + " has " +
                                       std::to_string(statement.arguments.size()) + " numbers; give one");
  }
  return checked_number(source, statement, statement.arguments[0], most);
}

/// `Ks r g b`, or `Ks r` for grey.
glm::dvec3 specular_color(const SourceText& source, const Statement& statement) {
  const std::vector<std::string_view>& arguments = statement.arguments;
  if (statement.keyword.empty()) {
    return glm::dvec3(0.0);
  }
  if (arguments.size() != 1 && arguments.size() != 3) {
    source.fail(statement.keyword, "Ks has " + std::to_string(arguments.size()) +
                                       " numbers; give three (red green blue) or one");
  }
  glm::dvec3 color;
  for (int channel = 0; channel < 3; ++channel) {
    const auto at = static_cast<std::size_t>(arguments.size() == 3 ? channel : 0);
    color[channel] = checked_number(source, statement, arguments[at], 1.0);
  }
  return color;
}

bool emits(const glm::dvec3& emission) {
  return emission.x > 0.0 || emission.y > 0.0 || emission.z > 0.0;
}

void refuse_unsupported(const MtlMaterial& definition, const MtlColor& color) {
  if (!color.unsupported.empty()) {
    definition.source->fail(color.unsupported, "'" + std::string(color.unsupported) +
                                                   "' colours are not supported; give red green blue");
  }
}

/// "the material 'name' has Kd 'token'"
std::string describe(const MtlMaterial& definition, const char* keyword, std::string_view token) {
  return "the material " + quote(definition.name) + " has " + keyword + " " + quote(token);
}

}  // namespace

std::uint32_t MaterialTable::use(const std::string& name, const SourceText& source, std::string_view token) {
  const auto known = by_name_.find(name);
  if (known != by_name_.end()) {
    return known->second;
  }
  if (name.empty()) {
    warnings_.say_once("no material", source, token,
                       "faces without a usemtl get a default material, Kd 0.5 and no emission");
    materials_.push_back({"(default)", glm::dvec3(kDefaultReflectance), glm::dvec3(0.0)});
  } else {
    const MtlMaterial* definition = library_.find(name);
    if (definition == nullptr) {
      refuse_unknown(name, source, token);
    }
    materials_.push_back(check(*definition));
  }
  const auto index = static_cast<std::uint32_t>(materials_.size() - 1);
  by_name_.emplace(name, index);
  return index;
}

Material MaterialTable::check(const MtlMaterial& definition) {
  Material material;
  material.name = definition.name;
  material.reflectance = check_reflectance(definition);
  material.emission = check_emission(definition);
  if (!definition.reflectance.given && !emits(material.emission)) {
    warnings_.say_once("no Kd", *definition.source, definition.statement,
                       "the material " + quote(definition.name) + " has no Kd and is taken as black");
  }
  read_appearance(definition, material);
  warn_about_textures(definition);
  return material;
}

void MaterialTable::read_appearance(const MtlMaterial& definition, Material& material) {
  const SourceText& source = *definition.source;
  const double model = single_number(source, definition.illumination, kMaxModel);
  if (model >= kHighlightModel) {
    material.specular = specular_color(source, definition.specular);
    material.exponent = single_number(source, definition.exponent, kMaxExponent);
    material.is_mirror = is_mirror_model(model) && material.specular != glm::dvec3(0.0);
  }
}

glm::dvec3 MaterialTable::check_reflectance(const MtlMaterial& definition) {
  const MtlColor& color = definition.reflectance;
  refuse_unsupported(definition, color);
  glm::dvec3 reflectance = color.value;
  for (int channel = 0; channel < 3; ++channel) {
    const std::string_view token = color.tokens[static_cast<std::size_t>(channel)];
    double& value = reflectance[channel];
    if (!std::isfinite(value)) {
      definition.source->fail(token,
                              describe(definition, "Kd", token) + ", no finite number; give 0 to below 1");
    }
    if (value < 0.0) {
      definition.source->fail(token, describe(definition, "Kd", token) + ", below 0; give 0 to below 1");
    }
    if (max_reflectance_ && value > *max_reflectance_) {
      warnings_.say_once("clamped Kd", *definition.source, token,
                         "Kd is clamped to the maximum reflectance, here and wherever it is larger");
      value = *max_reflectance_;
    }
    if (value >= 1.0) {
      definition.source->fail(token,
                              describe(definition, "Kd", token) +
                                  ", but a surface reflects less than it receives (Kd < 1); lower it or "
                                  "clamp it with --max-reflectance 0.95");
    }
  }
  return reflectance;
}

glm::dvec3 MaterialTable::check_emission(const MtlMaterial& definition) {
  const MtlColor& color = definition.emission;
  refuse_unsupported(definition, color);
  for (int channel = 0; channel < 3; ++channel) {
    const std::string_view token = color.tokens[static_cast<std::size_t>(channel)];
    const double value = color.value[channel];
    if (!std::isfinite(value)) {
      definition.source->fail(token,
                              describe(definition, "Ke", token) + ", no finite number; give 0 or more");
    }
    if (value < 0.0) {
      definition.source->fail(token, describe(definition, "Ke", token) + ", below 0; give 0 or more");
    }
    if (value > 0.0 && value < kMinEmission) {
      definition.source->fail(token,
                              describe(definition, "Ke", token) + ", below 1e-30; give 0 or more light");
    }
    if (value > kMaxEmission) {
      definition.source->fail(token, describe(definition, "Ke", token) + ", above 1e30; use a larger unit");
    }
  }
  return color.value;
}

void MaterialTable::warn_about_textures(const MtlMaterial& definition) {
  if (!definition.map_kd.empty()) {
    warnings_.say_once("map_Kd", *definition.source, definition.map_kd,
                       "textures (map_Kd) are not used; Kd alone is the reflectance");
  }
  if (!definition.map_ke.empty()) {
    warnings_.say_once("map_Ke", *definition.source, definition.map_ke,
                       "textures (map_Ke) are not used; Ke alone is the emission");
  }
}

void MaterialTable::refuse_unknown(const std::string& name, const SourceText& source,
                                   std::string_view token) const {
  std::string message = "no MTL file defines the material " + quote(name) + "; ";
  const std::vector<MtlMaterial>& available = library_.materials();
  if (!library_.has_files()) {
    source.fail(token, message + "add an mtllib statement that names the scene's .mtl file");
  }
  if (available.empty()) {
    source.fail(token, message + "add it, the MTL files define none");
  }
  message += "add it or use one of ";
  const std::size_t listed = std::min(available.size(), kMaxNamesListed);
  for (std::size_t i = 0; i < listed; ++i) {
    message += (i == 0 ? "" : ", ") + quote(available[i].name);
  }
  source.fail(token, message + (listed < available.size() ? ", ..." : ""));
}

void MaterialTable::require_lamp(const std::string& path) const {
  const auto is_lamp = [](const Material& material) { return emits(material.emission); };
  if (std::any_of(materials_.begin(), materials_.end(), is_lamp)) {
    return;
  }
  for (const MtlMaterial& definition : library_.materials()) {
    if (emits(definition.emission.value)) {
      throw InputError(path + ": error: nothing emits light: no face uses the material " +
                       quote(definition.name) +
                       ", the one with a Ke; use it or give another material a Ke above 0");
    }
  }
  throw InputError(path + ": error: nothing emits light; give a material that faces use a Ke above 0");
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/io/model.h"
#include "host_sim/io/mtl_library.h"
#include "host_sim/io/source_text.h"
#include "host_sim/io/warnings.h"

namespace fixrad::host {

/// The materials that faces use, checked when the first face does.
class MaterialTable {
 public:
  MaterialTable(const MtlLibrary& library, std::optional<double> max_reflectance, Warnings& warnings)
      : library_(library), max_reflectance_(max_reflectance), warnings_(warnings) {}

  /// The index of the material `name`, which the `usemtl` at `token` asks for; the empty name is the default
  /// material (Kd 0.5, with one warning). Throws InputError if no MTL file defines it, Kd is outside [0, 1)
  /// and not to be clamped, Ke is negative, or a value is not finite; or if `illum` asks for highlights or a
  /// mirror and Ks or Ns is not in range. Without that Ks and Ns are not read: many tools write them for
  /// every material.
  std::uint32_t use(const std::string& name, const SourceText& source, std::string_view token);

  const std::vector<Material>& materials() const { return materials_; }

  /// Throws InputError `path: error: nothing emits light; ...` unless a used material has Ke > 0.
  void require_lamp(const std::string& path) const;

 private:
  Material check(const MtlMaterial& definition);
  glm::dvec3 check_reflectance(const MtlMaterial& definition);
  glm::dvec3 check_emission(const MtlMaterial& definition);
  static void read_appearance(const MtlMaterial& definition, Material& material);
  void warn_about_textures(const MtlMaterial& definition);
  [[noreturn]] void refuse_unknown(const std::string& name, const SourceText& source,
                                   std::string_view token) const;

  const MtlLibrary& library_;
  std::optional<double> max_reflectance_;
  Warnings& warnings_;
  std::vector<Material> materials_;
  std::map<std::string, std::uint32_t> by_name_;
};

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/io/source_text.h"
#include "host_sim/io/warnings.h"

namespace fixrad::host {

/// A colour as an MTL file states it: not yet checked, since a material that no face uses may hold anything.
struct MtlColor {
  bool given = false;
  glm::dvec3 value{0.0};                     ///< may be NaN, infinite or out of range
  std::array<std::string_view, 3> tokens{};  ///< where the channels stand
  std::string_view unsupported;              ///< "spectral" or "xyz", else empty
};

/// A `newmtl` with what this program uses of it. Views point into source.
struct MtlMaterial {
  std::string name;
  const SourceText* source = nullptr;
  std::string_view statement;  ///< the keyword newmtl
  MtlColor reflectance;        ///< `Kd`
  MtlColor emission;           ///< `Ke`
  Statement specular;          ///< `Ks`, `Ns`, `illum`, unread; empty keywords where they are not given
  Statement exponent;
  Statement illumination;
  std::string_view map_kd;  ///< the keyword of a texture, empty without one
  std::string_view map_ke;
};

/// The materials of all MTL files of a scene. Format: Wavefront "MTL material format", 4.2 (October 1995),
/// with `Ke` and the physically based statements that modelling tools added.
class MtlLibrary {
 public:
  /// Adds the materials of one MTL file. A name that is known already is replaced, with a warning.
  /// Throws InputError for malformed text. Well-known statements without use here are skipped silently,
  /// others with one warning each.
  void load(const std::string& path, std::string text, Warnings& warnings);

  /// The material of that name, or null. Valid until the next load().
  const MtlMaterial* find(const std::string& name) const;

  bool has_files() const { return !sources_.empty(); }

  /// All materials in file order.
  const std::vector<MtlMaterial>& materials() const { return materials_; }

 private:
  MtlMaterial* open(const SourceText& source, const Statement& statement, Warnings& warnings);

  std::deque<SourceText> sources_;  // a deque: views into an element stay valid when others are added
  std::vector<MtlMaterial> materials_;
  std::map<std::string, std::size_t> by_name_;
};

}  // namespace fixrad::host

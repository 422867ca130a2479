// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace fixrad::host {

/// Bad input. what() is one complete line for the user: `file:line:column: error: what is wrong; what to do`
/// (line and column are left out where the fault has none, a missing file for instance).
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Over red, green and blue of a reflectance, an exitance or a radiosity.
inline double channel_sum(const glm::dvec3& a) {
  return a.x + a.y + a.z;
}

/// A Lambertian material: light is transported by Kd and Ke alone. The rest is what pictures show of it
/// beside diffuse light. Channels are red, green, blue.
struct Material {
  std::string name;
  glm::dvec3 reflectance{0.0};  ///< MTL `Kd`, diffuse reflectance, in [0, 1) once read
  glm::dvec3 emission{0.0};     ///< MTL `Ke`, emitted radiosity (exitance), W/m^2, >= 0
  glm::dvec3 specular{0.0};     ///< MTL `Ks`, in [0, 1], of what `illum` asks for; 0 if for nothing
  double exponent = 0.0;        ///< MTL `Ns` with `illum` 2 or more, in [0, 1000]: highlights; 0: none
  bool is_mirror = false;       ///< MTL `illum` 3 or 5: its faces show a mirror image
};

/// A polygon as the file gives it: any simple planar polygon, 3 corners or more, not necessarily convex.
struct Face {
  std::vector<std::uint32_t>
      corners;                 ///< indices into Model::positions, counter-clockwise seen from the lit side
  std::uint32_t material = 0;  ///< index into Model::materials
  std::uint32_t smoothing_group = 0;  ///< OBJ `s`; 0 = off
  int line = 0;                       ///< line of the `f` statement, for messages
};

/// What a scene file says, nothing derived. Faces stay in file order: face i is the i-th `f` of the file.
struct Model {
  std::string path;                   ///< the file, as the user named it
  std::vector<glm::dvec3> positions;  ///< in the file's unit
  std::vector<Face> faces;
  std::size_t file_faces = 0;         ///< how many are the file's own; reversed twins follow them
  std::vector<Material> materials;    ///< those that a face uses, in order of first use
  std::vector<std::string> warnings;  ///< complete lines `file:line:column: warning: ...`, each said once
};

}  // namespace fixrad::host

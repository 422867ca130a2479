// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace fixrad::host {

/// One element's result, a row of the .csv.
struct BakedElement {
  std::uint32_t index = 0;
  std::uint32_t input_face = 0;
  std::string material;
  glm::dvec3 centroid{0.0};
  double area = 0.0;
  glm::dvec3 radiosity{0.0};  ///< W/m^2, unit of MTL Ke, linear, always three channels
  bool lamp = false;          ///< its material emits; lamps do not drive the automatic exposure
};

/// What a material shows beside diffuse light, see Material.
struct Appearance {
  glm::dvec3 specular{0.0};
  double exponent = 0.0;
  bool is_mirror = false;
};

/// A lamp as highlights see it: a Lambertian point light.
struct BakedLamp {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  ///< unit, towards the lit side
  double area = 0.0;
  glm::dvec3 radiosity{0.0};  ///< emitted, W/m^2
};

/// A solution as a renderer wants it: a triangle mesh with vertex radiosity. Vertices are not shared across
/// creases or materials, so a normal is unique.
struct BakedMesh {
  std::string name;                                     ///< scene name without folder and suffix
  std::vector<glm::dvec3> positions;                    ///< scene unit
  std::vector<glm::dvec3> normals;                      ///< unit, towards the lit side
  std::vector<glm::dvec3> radiosity;                    ///< a vertex, W/m^2, linear, finite, >= 0
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from the lit side
  std::vector<BakedElement> elements;
  std::vector<Appearance> appearances;             ///< none: all is matt
  std::vector<std::uint32_t> triangle_appearance;  ///< [triangles], into appearances, where there are any
  std::vector<BakedLamp> lamps;                    ///< read where a material has highlights
};

/// How radiosity becomes a displayed colour: colour = sRGB(tone(radiosity * 2^exposure_ev * scale)).
struct Display {
  double exposure_ev = 0.0;  ///< the user's correction on top of the automatic exposure, stops
  bool z_up = false;         ///< --up z
};

}  // namespace fixrad::host

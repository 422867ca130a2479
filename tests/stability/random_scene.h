// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host_sim/io/model.h"

namespace fixrad::host {

/// A random scene in parts, so that it can be made smaller part by part. Lengths are whole grid units, the
/// longest side of the room is kGridRoom, and the rest fits in.
struct RandomScene {
  enum class Kind { box, octahedron, quad, triangle };
  struct Body {
    Kind kind;
    glm::ivec3 low, size;  ///< its bounding box before it is turned; quads and triangles tilt within it
    int degrees;           ///< turned about its middle and the vertical; boxes, octahedra
    std::uint32_t material;
  };
  struct Paint {
    glm::ivec3 reflectance, emission;  ///< hundredths; emission: hundredths too
  };

  std::uint64_t seed = 0;
  bool is_closed = false;       ///< a whole room in which only closed bodies stand or float
  glm::ivec3 room{0};           ///< its size
  std::array<bool, 6> walls{};  ///< which stand; all if closed
  std::array<std::uint32_t, 6> wall_paint{};
  std::vector<Paint> paints;  ///< the first one emits
  std::vector<Body> bodies;

  // How it is solved.
  enum class Hemisphere { lunes, hemicube, pixels };
  Hemisphere hemisphere = Hemisphere::lunes;
  std::uint32_t elements = 0;
  int rows = 0;  ///< R of the strongest shots
  bool overshoot = false, knows_sights = false;
};

/// The scene of a seed: closed or open by halves, grey or coloured, of all kinds of bodies, solved by any of
/// the core's hemispheres. Depends on the seed alone.
RandomScene random_scene(std::uint64_t seed);

Model model_of(const RandomScene& scene);

/// Scenes that are simpler by one step each, the largest steps first: without a body or a wall, without
/// colours, with one lamp, in fewer elements, of rounder numbers.
std::vector<RandomScene> simpler(const RandomScene& scene);

/// One line: seed, kind, how it is solved.
std::string describe(const RandomScene& scene);

}  // namespace fixrad::host

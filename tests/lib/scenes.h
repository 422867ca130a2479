// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

#include "host_sim/io/model.h"

namespace fixrad::host {

/// Random numbers that are the same with every standard library: only the engine is used, no distribution.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  std::uint32_t bits() { return static_cast<std::uint32_t>(engine_()); }
  /// low..high, both included.
  int between(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint32_t>(high - low + 1));
  }
  /// [low, high).
  double real(double low, double high) { return low + (high - low) * (bits() / 4294967296.0); }

 private:
  std::mt19937 engine_;
};

/// Makes a Model in memory. Lengths in metres.
class ModelBuilder {
 public:
  ModelBuilder() { model_.path = "test"; }

  /// Returns the material's index.
  std::uint32_t material(glm::dvec3 reflectance, glm::dvec3 emission = glm::dvec3(0.0));
  /// A polygon, counter-clockwise seen from its lit side; equal positions are shared.
  void polygon(const std::vector<glm::dvec3>& corners, std::uint32_t material);
  /// An axis-parallel room seen from inside; faces in the order -x +x -y +y -z +z.
  void room(glm::dvec3 low, glm::dvec3 high, const std::array<std::uint32_t, 6>& materials);
  /// A box seen from outside, turned by `angle` about the vertical (y) through its middle; without a bottom
  /// on request.
  void box(glm::dvec3 low, glm::dvec3 high, double angle, std::uint32_t material, bool has_bottom = true);
  /// An octahedron seen from outside, tilted in every axis.
  void octahedron(glm::dvec3 middle, double radius, double angle, std::uint32_t material);

  const Model& model() const { return model_; }

 private:
  std::uint32_t vertex(glm::dvec3 p);

  Model model_;
};

/// How many seeds a test of random scenes goes through: what the environment says in FIXRAD_SCENES, for long
/// runs, else `usual`.
std::uint32_t seed_count(std::uint32_t usual);

/// The unit cube seen from inside, one material a face; faces in the order -x +x -y +y -z +z.
Model cube(double reflectance, const std::array<double, 6>& emission);

/// A closed room with one to four closed bodies, each in its own quarter of the floor plan (none pierces
/// another), standing on the floor or floating, and a lamp that is a wall or a body. RGB.
Model random_closed_room(std::uint32_t seed);

/// A room of which up to three walls are missing, with free boxes that may lack a bottom or pierce each
/// other. RGB.
Model random_open_room(std::uint32_t seed);

/// A closed lit cube of 4 m with a box of 1 x 1 x 1 m in the middle of its floor: without a bottom on the
/// floor, or closed and standing, or closed and floating half a metre above.
enum class Stand { without_bottom, closed_on_floor, floating };
Model room_with_box(Stand stand, double angle);

/// Two unit squares a metre apart that face each other: face 0 looks up, face 1 looks down at it.
Model parallel_squares(double reflectance0, double emission0, double reflectance1);

/// Two unit squares at right angles with a common edge: face 0 is the floor, face 1 the wall.
Model perpendicular_squares(double reflectance0, double emission0, double reflectance1);

/// scenes/cornell.obj.
Model cornell();

}  // namespace fixrad::host

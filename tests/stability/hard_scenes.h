// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "tests/lib/scenes.h"

namespace fixrad::host {

/// The side of a room that fills the device's grid: with it as the longest side of a scene, a unit of length
/// is a grid unit, and whole numbers stay what they are.
constexpr double kGridRoom = 16367;

/// A closed room of side 1 with a square lamp of side `lamp` in the middle of its ceiling, in one plane with
/// it and sharing its corners. Input faces: five walls (-x +x -y -z +z), four parts of the ceiling, the lamp.
Model room_with_inset_lamp(double lamp, double reflectance);

/// A square of side `side`, lit side up (or down), its middle at `middle`.
void square(ModelBuilder& builder, glm::dvec3 middle, double side, bool faces_up, std::uint32_t material);

/// A room of the grid's size whose -x and +x walls glow, of one reflectance.
void lit_grid_room(ModelBuilder& builder, double reflectance);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/io/model.h"

namespace fixrad::host {

/// The 48 images of a model under the symmetries of the cube: all permutations of the axes with all mirrors.
/// The first is the model itself; faces keep their order, and their winding is turned where space is
/// mirrored.
std::vector<Model> images_of(const Model& model);

/// A point under symmetry `i` of 48; mirrored coordinates are taken from `extent`.
glm::ivec3 image_of(glm::ivec3 p, std::size_t i, int extent);

/// Whether image `i` of 48 is a rotation; the others are mirrored.
bool is_rotation(std::size_t i);

}  // namespace fixrad::host

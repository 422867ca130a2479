// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host_sim/io/model.h"

namespace fixrad::host {

/// The 48 images of a model under the symmetries of the cube: all permutations of the axes with all mirrors.
/// The first is the model itself; faces keep their order, and their winding is turned where space is
/// mirrored.
std::vector<Model> images_of(const Model& model);

/// Whether image `i` of 48 is a rotation; the others are mirrored.
bool is_rotation(std::size_t i);

}  // namespace fixrad::host

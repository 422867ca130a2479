// SPDX-License-Identifier: MIT
#pragma once

#include "lib/fixrad.h"

namespace fixrad {
namespace device_test {

constexpr uint8_t kElementsPerFace = 4;

/// A Material::emission for the box.
constexpr uint32_t kEmission = 1ul << 25;
constexpr int32_t kEmitted = 1l << 20;  ///< flux that an element of kEmission emits, and its radiosity

/// A cube seen from inside, its faces in the order -x +x -y +y -z +z with 2 x 2 elements and one patch each;
/// face i has material i of `materials`. With `faces` < 6 the last ones are missing and light escapes.
Scene box_scene(const FIXRAD_FLASH Material* materials, uint8_t faces = 6, uint8_t channels = 1);

/// Hemicube rows at R = 16 with one eye point an element.
Settings box_settings();

/// With room for box_scene() in three channels, and for pixels at R = 8.
using BoxSolver = Solver<Limits<8, 6, 24, 14, 3, 8>>;

/// The one solver that all tests share, since 8 KB hold no more; a test begins with load().
BoxSolver& box_solver();

/// Steps until the status is not ok; returns it.
Status run(BoxSolver& solver);

}  // namespace device_test
}  // namespace fixrad

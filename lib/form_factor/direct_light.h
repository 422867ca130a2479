// SPDX-License-Identifier: MIT
#pragma once

#include "lib/form_factor/row.h"
#include "lib/form_factor/view.h"

namespace fixrad {

/// Corrects the finished row of one eye that looks on its own. See correct_direct_light().
using DirectLight = void (*)(const Scene& scene, const EyePoint& eye, Workspace& work, FormFactorRow& row);

/// Replaces the entries of elements that emit by the closed form (contour_factor()), times the part of up
/// to 32 rays to each that nothing blocks, the more the more it gives. A lamp that spans few rows, or falls
/// between two, is sampled badly and is most of the light of what it shines on. All other entries, back and
/// escaped among them, make room in proportion, so the row keeps its sum kRowOne, exactly. Faces that fill
/// more than 1/kLargeLamp of the hemisphere span rows enough and stay as sampled, as do lamps that give
/// little of what all of them do. Uses work.views. Cost: a contour a face that emits; of those that are
/// corrected, RayBlockers::enter_target(), and a contour and up to 32 rays an element.
void correct_direct_light(const Scene& scene, const EyePoint& eye, Workspace& work, FormFactorRow& row);

constexpr int kLargeLamp = 8;

}  // namespace fixrad

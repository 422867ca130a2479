// SPDX-License-Identifier: MIT
#pragma once

#include "lib/form_factor/row.h"
#include "lib/form_factor/view.h"
#include "lib/scene/status.h"

namespace fixrad {

/// Corrects the finished row of an element. Statuses: ok, and in_progress as an engine's: the next call goes
/// on. See correct_near_field().
using NearField = Status (*)(const Scene& scene, uint16_t element, Workspace& work, FormFactorRow& row);

/// Replaces the entries of elements nearer to `element` than half the size of the larger of the two (square
/// roots of their areas, distance of their centroids) by the closed form: the contour formula's mean over
/// four points of the smaller one (by reciprocity, where that is the receiver), times the part of eight rays
/// between the two that nothing blocks. All other entries, back and escaped among them, make room in
/// proportion, so the row keeps its sum kRowOne, exactly. Rays from a part that something stands on are
/// blocked, which keeps elements across a contact line from lighting the foot of what stands there. Uses
/// work.views. docs/near_field.md has what it is worth. Cost: three products an element, 8 contours and 8
/// rays a near pair.
Status correct_near_field(const Scene& scene, uint16_t element, Workspace& work, FormFactorRow& row);

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host_sim/meshing/critical_lines.h"

namespace fixrad::host {

/// Joins lines of one face that lie on one straight line (to a grid unit) and overlap or touch; the joined
/// one keeps what is said of the most important. Then leaves out those that run within `separation` grid
/// units of a more important one, those on the border of their face, and those no longer than rounding. Does
/// not depend on the order of `lines`. Cost: the square of the lines that remain of a face.
std::vector<CriticalLine> merge_lines(const PreparedScene& scene, std::vector<CriticalLine> lines,
                                      double separation);

}  // namespace fixrad::host

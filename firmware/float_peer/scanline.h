// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/view.h"

namespace fixrad {
namespace peer {

/// The five sides of a hemicube, as in the core: each is the top seen in permuted axes, z away from the eye
/// through the middle of the side. In pixels a side reaches from -R/2 to R/2, position x of row r has
/// direction (x, r + 1/2 - R/2, R/2).
constexpr uint8_t kSides = 5;
constexpr uint8_t kTop = 0;

/// Part of a row, pixels from its middle: [begin, end), empty if begin >= end.
struct Interval {
  float begin, end;
};

/// First row of a side whose resolution is 2 half; the four sides end at the horizon.
inline uint8_t first_row(uint8_t side, uint8_t half) {
  return side == kTop ? static_cast<uint8_t>(0) : half;
}

/// Turns the view from the axes of the side before to those of `side` (sides are entered in order, from
/// kTop) and finds the rows of `side` that each face crosses. Cost: one division a vertex, two products a
/// linear function of a face.
void enter_side(const Scene& scene, uint8_t side, uint8_t half, Workspace& work);

/// The part of a row, from -size to size, that a face covers; to be called for each of its rows (begin_row ..
/// end_row - 1) in order.
///
/// Which edges cross the row follows from the side of the row's plane that each vertex is on, as in the core;
/// they stay the same until a vertex of the face changes sides. An edge starts from its vertices alone, at
/// the same row in both faces that share it, and is stepped from there: neighbours tile the row. Cost: up to
/// five sums and three comparisons a row, one division where an edge begins.
Interval face_interval(const Scene& scene, uint8_t row, float size, const VertexView* vertices,
                       FaceView& view);

}  // namespace peer
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "firmware/float_peer/split.h"

namespace fixrad {
namespace peer {
namespace {

// Rounding may put the ends of an interval just outside its face, and a face seen edge-on may put them
// anywhere.
uint8_t cell_of(float coordinate, uint8_t cells) {
  const int32_t cell = __builtin_fabsf(coordinate) < 256.0f ? static_cast<int32_t>(coordinate) : 0;
  return static_cast<uint8_t>(cell < 0 ? 0 : (cell < cells ? cell : cells - 1));
}

}  // namespace

ElementWalk::ElementWalk(const Scene& scene, const FaceView& view, float y, Interval part)
    : scene_(scene), view_(view), end_(part.begin), last_(part.end) {
  if (!view.has_u() && !view.has_v()) {
    return;
  }
  const float begin_depth = 1.0f / view.row_depth(part.begin);
  const float end_depth = 1.0f / view.row_depth(part.end);
  if (view.has_u()) {
    start_axis(u_, on_row(view.u, y), view.cells_u, part.begin, begin_depth, end_depth);
  }
  if (view.has_v()) {
    start_axis(v_, on_row(view.v, y), view.cells_v, part.begin, begin_depth, end_depth);
  }
}

void ElementWalk::start_axis(Axis& axis, const RowFunction& value, uint8_t cells, float begin,
                             float begin_depth, float end_depth) const {
  axis.cell = cell_of(value(begin) * begin_depth, cells);
  const uint8_t last = cell_of(value(last_) * end_depth, cells);
  if (axis.cell == last) {
    return;
  }
  axis.step = axis.cell < last ? 1 : -1;
  axis.left = static_cast<uint8_t>(axis.cell < last ? last - axis.cell : axis.cell - last);
  const float line = static_cast<float>(axis.cell < last ? axis.cell + 1 : axis.cell);
  axis.at_row = value.at_row - line * view_.row_depth.at_row;
  axis.slope = value.slope - line * view_.row_depth.slope;
  find_border(axis);
}

// A row that runs along a grid line has no crossing to speak of: 0/0 counts as the end.
void ElementWalk::find_border(Axis& axis) const {
  const float x = -axis.at_row / axis.slope;
  axis.border = x < last_ ? x : last_;
}

void ElementWalk::pass_border(Axis& axis) const {
  axis.cell = static_cast<uint8_t>(axis.cell + axis.step);
  if (--axis.left == 0) {
    return;
  }
  if (axis.step > 0) {
    axis.at_row -= view_.row_depth.at_row;
    axis.slope -= view_.row_depth.slope;
  } else {
    axis.at_row += view_.row_depth.at_row;
    axis.slope += view_.row_depth.slope;
  }
  find_border(axis);
}

uint16_t ElementWalk::element_at(uint8_t u, uint8_t v) const {
  const CellRow row = flash_read(scene_.cell_rows, static_cast<unsigned>(view_.first_cell_row) + v);
  const uint8_t cell = u < row.first_cell ? row.first_cell : (u > row.last_cell ? row.last_cell : u);
  return static_cast<uint16_t>(row.first_element + (cell - row.first_cell));
}

bool ElementWalk::next() {
  if (is_done_) {
    return false;
  }
  element_ = element_at(u_.cell, v_.cell);
  if (u_.left == 0 && v_.left == 0) {
    end_ = last_;
    is_done_ = true;
    return true;
  }
  Axis& nearer = v_.left == 0 || (u_.left != 0 && u_.border <= v_.border) ? u_ : v_;
  end_ = nearer.border > end_ ? nearer.border : end_;
  pass_border(nearer);
  return true;
}

}  // namespace peer
}  // namespace fixrad

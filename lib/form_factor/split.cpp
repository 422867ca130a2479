// SPDX-License-Identifier: MIT
#include "lib/form_factor/split.h"

#include "lib/form_factor/delta_table.h"

namespace fixrad {
namespace {

// value / weight rounded down into [0, cells): rounding may put the ends of an interval just outside its
// face.
int16_t cell_of(int32_t value, int32_t weight, uint8_t cells) {
  if (value <= 0 || weight <= 0 || cells == 1) {
    return 0;
  }
  const int32_t cell = value / weight;
  return static_cast<int16_t>(cell < cells ? cell : cells - 1);
}

}  // namespace

ElementWalk::ElementWalk(const Scene& scene, const FaceView& view, const RowPosition& at, Interval part)
    : scene_(scene), view_(view), part_(part), end_(part.begin) {
  u_ = {0, 0, 0, 1, 0, part.end};
  v_ = {0, 0, 0, 1, 0, part.end};
  begin_weight_ = end_weight_ = 1;
  if (view_.cells_u * view_.cells_v > 1) {
    const Vec3 d0 = at.direction(part.begin);
    const Vec3 d1 = at.direction(part.end);
    begin_weight_ = dot(view.grid_n, d0);
    end_weight_ = dot(view.grid_n, d1);
    start_axis(u_, view.grid_u, view_.cells_u, d0, d1);
    start_axis(v_, view.grid_v, view_.cells_v, d0, d1);
  }
}

void ElementWalk::start_axis(Axis& axis, Vec3 grid, uint8_t cells, Vec3 d0, Vec3 d1) const {
  if (cells == 1) {
    return;
  }
  axis.begin_value = dot(grid, d0);
  axis.end_value = dot(grid, d1);
  axis.cells = cells;
  axis.cell = cell_of(axis.begin_value, begin_weight_, cells);
  axis.step = axis.end_value < axis.cell * end_weight_ ? -1 : 1;
  find_border(axis);
}

// The line between cell k - 1 and k is the zero of value - k weight, which is linear along the row; the
// interval reaches it if its end is beyond.
void ElementWalk::find_border(Axis& axis) const {
  const int32_t k = axis.step > 0 ? axis.cell + 1 : axis.cell;
  const int32_t beyond = axis.end_value - k * end_weight_;
  if (k <= 0 || k >= axis.cells || (axis.step > 0 ? beyond < 0 : beyond >= 0)) {
    axis.step = 0;
    axis.border = part_.end;
    return;
  }
  uint32_t a = magnitude(axis.begin_value - k * begin_weight_);
  uint32_t b = magnitude(beyond);
  const int excess = bit_length(a | b) - 19;  // leaves room for 12 bits of width and the sum's carry
  if (excess > 0) {
    a >>= excess;
    b >>= excess;
  }
  const uint32_t width = static_cast<uint32_t>(part_.end - part_.begin);
  axis.border = part_.begin + (a + b == 0 ? 0 : static_cast<int32_t>(width * a / (a + b)));
}

uint16_t ElementWalk::element_at(int16_t u, int16_t v) const {
  const CellRow row = flash_read(scene_.cell_rows, static_cast<unsigned>(view_.first_cell_row + v));
  const int16_t cell = u < row.first_cell ? row.first_cell : (u > row.last_cell ? row.last_cell : u);
  return static_cast<uint16_t>(row.first_element + (cell - row.first_cell));
}

bool ElementWalk::next() {
  if (end_ >= part_.end) {
    return false;
  }
  const int32_t begin = end_;
  element_ = element_at(u_.cell, v_.cell);
  Axis& nearer = u_.border <= v_.border ? u_ : v_;
  end_ = nearer.border > begin ? nearer.border : begin;
  if (nearer.step != 0) {
    nearer.cell = static_cast<int16_t>(nearer.cell + nearer.step);
    find_border(nearer);
  } else {
    end_ = part_.end;
  }
  return true;
}

}  // namespace fixrad

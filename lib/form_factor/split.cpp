// SPDX-License-Identifier: MIT
#include "lib/form_factor/split.h"

#include "lib/form_factor/delta_table.h"

namespace fixrad {
namespace {

// The part along a row's m of a vector of the grid, 2^-kPlaneBits of its unit.
int32_t along(Vec3 grid, const RowPlane& plane) {
  return grid.y * plane.y + grid.z * plane.z;
}

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

ElementWalk::ElementWalk(const Scene& scene, const FaceView& view, const RowPlane& plane, Interval part)
    : scene_(scene), view_(view), part_(part), fold_(plane.fold), end_(part.begin) {
  u_ = v_ = {0, 0, 0, part.end, 0, 1, 0};
  if (view_.cells_u * view_.cells_v > 1) {
    const int32_t x0 = part.begin - kRowMiddle, x1 = part.end - kRowMiddle;
    begin_point_ = {x0, row_weight(x0, plane.fold)};
    end_point_ = {x1, row_weight(x1, plane.fold)};
    weight_x_ = view.grid_n.x;
    weight_m_ = along(view.grid_n, plane);
    begin_weight_ = begin_point_.of(weight_x_, weight_m_);
    end_weight_ = end_point_.of(weight_x_, weight_m_);
    start_axis(u_, view.grid_u, view_.cells_u, plane);
    start_axis(v_, view.grid_v, view_.cells_v, plane);
  }
}

void ElementWalk::start_axis(Axis& axis, const Vec3& grid, uint8_t cells, const RowPlane& plane) {
  if (cells == 1) {
    return;
  }
  axis.x = grid.x;
  axis.m = along(grid, plane);
  axis.end_value = end_point_.of(axis.x, axis.m);
  axis.cells = cells;
  axis.cell = cell_of(begin_point_.of(axis.x, axis.m), begin_weight_, cells);
  axis.step = axis.end_value < axis.cell * end_weight_ ? -1 : 1;
  find_border(axis);
}

// The line between cell k - 1 and k is the zero of value - k weight; the interval reaches it if its end is
// beyond.
void ElementWalk::find_border(Axis& axis) const {
  const int32_t k = axis.step > 0 ? axis.cell + 1 : axis.cell;
  const int32_t beyond = axis.end_value - k * end_weight_;
  if (k <= 0 || k >= axis.cells || (axis.step > 0 ? beyond < 0 : beyond >= 0)) {
    axis.step = 0;
    axis.border = part_.end;
    return;
  }
  // Lines of a fine grid differ in their last bits only: the sum is formed with all of them and then cut.
  int32_t x = (axis.x - k * weight_x_) * (static_cast<int32_t>(1) << kPlaneBits);
  int32_t m = axis.m - k * weight_m_;
  const int excess = bit_length(magnitude(x) | magnitude(m)) - kCrossingBits;
  if (excess > 0) {
    x = floor_shift(x, excess);
    m = floor_shift(m, excess);
  }
  axis.border = crossing_within(part_, axis.step > 0, x, m, fold_);
}

uint16_t ElementWalk::element_at(int16_t u, int16_t v) {
  if (v != cell_row_number_) {
    cell_row_ = flash_read(scene_.cell_rows, view_.first_cell_row + static_cast<unsigned>(v));
    cell_row_number_ = v;
  }
  const int16_t cell =
      u < cell_row_.first_cell ? cell_row_.first_cell : (u > cell_row_.last_cell ? cell_row_.last_cell : u);
  return static_cast<uint16_t>(cell_row_.first_element + static_cast<unsigned>(cell - cell_row_.first_cell));
}

bool ElementWalk::next() {
  if (end_ >= part_.end) {
    return false;
  }
  element_ = element_at(u_.cell, v_.cell);
  Axis& nearer = u_.border <= v_.border ? u_ : v_;
  if (nearer.step == 0) {
    end_ = part_.end;
    return true;
  }
  end_ = nearer.border > end_ ? nearer.border : end_;
  nearer.cell = static_cast<int16_t>(nearer.cell + nearer.step);
  find_border(nearer);
  return true;
}

}  // namespace fixrad

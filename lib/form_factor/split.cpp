// SPDX-License-Identifier: MIT
#include "lib/form_factor/split.h"

#include "lib/fixed/checked.h"

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

// Of a cut along a row, so that its value at a position stays below 2^30.
constexpr int kCutLineBits = 18;

int32_t line_value(int32_t x, int32_t m, int32_t position, uint32_t fold) {
  const int32_t from_middle = position - kRowMiddle;
  return x * from_middle + m * row_weight(from_middle, fold);
}

}  // namespace

ElementWalk::ElementWalk(const Scene& scene, const FaceView& view, const RowPlane& plane, Interval part)
    : scene_(scene), view_(view), part_(part), fold_(plane.fold), end_(part.begin) {
  u_ = v_ = {0, 0, 0, part.end, 0, 1, 0};
  if (has_grid(scene, view_)) {
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
  axis.x = grid.x;
  axis.m = along(grid, plane);
  if (cells == 1) {
    return;
  }
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

uint16_t ElementWalk::cell_at(int16_t u, int16_t v) {
  if (v != cell_row_number_) {
    cell_row_ = flash_read(scene_.cell_rows, view_.first_cell_row + static_cast<unsigned>(v));
    cell_row_number_ = v;
  }
  const int16_t cell =
      u < cell_row_.first_cell ? cell_row_.first_cell : (u > cell_row_.last_cell ? cell_row_.last_cell : u);
  return narrow<uint16_t>(cell_row_.first_element + static_cast<uint32_t>(cell - cell_row_.first_cell),
                          Place::element_of_cell);
}

// The first row of the grid that shows the same cells: sliver rows at the border repeat their neighbour.
int16_t ElementWalk::first_row_of_cell() const {
  int16_t v = cell_row_number_;
  while (v > 0 &&
         flash_read(scene_.cell_rows, view_.first_cell_row + static_cast<unsigned>(v - 1)).first_element ==
             cell_row_.first_element) {
    --v;
  }
  return v;
}

// A cut is the sum of three of these numbers times at most 2^9, 2^9 and 2^11: below 2^31.
void ElementWalk::enter_cell(uint16_t cell) {
  const int32_t u = cell_row_.first_cell + static_cast<int32_t>(cell) - cell_row_.first_element;
  const int32_t v = first_row_of_cell();
  constexpr int32_t kOne = static_cast<int32_t>(1) << kPlaneBits;
  int32_t lines[6] = {(u_.x - u * weight_x_) * kOne, (v_.x - v * weight_x_) * kOne, weight_x_ * kOne,
                      u_.m - u * weight_m_,          v_.m - v * weight_m_,          weight_m_};
  uint32_t all = 0;
  for (const int32_t line : lines) {
    all |= magnitude(line);
  }
  const int excess = bit_length(all) - kCrossingBits;
  for (int32_t& line : lines) {
    line = excess > 0 ? floor_shift(line, excess) : line;
  }
  cell_ = {lines[0], lines[1], lines[2], lines[3], lines[4], lines[5]};
}

// To the element that holds the beginning of `part`.
void ElementWalk::descend(uint16_t side, Interval part) {
  while (side < kLeaf) {
    const Cut cut = flash_read(scene_.cuts, side);
    int32_t x = cut.a * cell_.u_x + cut.b * cell_.v_x + cut.c * cell_.weight_x;
    int32_t m = cut.a * cell_.u_m + cut.b * cell_.v_m + cut.c * cell_.weight_m;
    const int excess = bit_length(magnitude(x) | magnitude(m)) - kCutLineBits;
    if (excess > 0) {
      x = floor_shift(x, excess);
      m = floor_shift(m, excess);
    }
    const bool begins_left = line_value(x, m, part.begin, fold_) >= 0;
    const bool ends_left = line_value(x, m, part.end, fold_) >= 0;
    const uint16_t near = begins_left ? cut.left : cut.right;
    const uint16_t far = begins_left ? cut.right : cut.left;
    side = near;
    if (begins_left != ends_left) {
      const int32_t border = crossing_within(part, ends_left, x, m, fold_);
      if (border <= part.begin) {
        side = far;
      } else if (border < part.end) {
        waiting_[waiting_count_++] = {far, narrow<int16_t>(part.end, Place::row_position)};
        part.end = border;
      }
    }
  }
  element_ = static_cast<uint16_t>(side - kLeaf);
  end_ = part.end;
}

bool ElementWalk::next() {
  if (waiting_count_ > 0) {
    const Waiting further = waiting_[--waiting_count_];
    descend(further.side, {end_, further.end});
    return true;
  }
  if (end_ >= part_.end) {
    return false;
  }
  const int32_t begin = end_;
  const uint16_t cell = cell_at(u_.cell, v_.cell);
  Axis& nearer = u_.border <= v_.border ? u_ : v_;
  if (nearer.step == 0) {
    end_ = part_.end;
  } else {
    end_ = nearer.border > end_ ? nearer.border : end_;
    nearer.cell = static_cast<int16_t>(nearer.cell + nearer.step);
    find_border(nearer);
  }
  if (scene_.roots == nullptr) {
    element_ = cell;
    return true;
  }
  const uint16_t root = flash_read(scene_.roots, cell);
  if (root < kLeaf) {
    enter_cell(cell);
  }
  descend(root, {begin, end_});
  return true;
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "host_sim/reference/twin_scanline.h"

namespace fixrad::host {

/// Walks the visible interval of one face along a row and cuts it where it crosses the face's element grid,
/// cell by cell, as ElementWalk of the core does.
///
///     for (TwinElementWalk walk(scene, view, row, part); walk.next();) use(walk.element(), walk.end());
class TwinElementWalk {
 public:
  /// Needs part.begin < part.end, and `view` to show its front.
  TwinElementWalk(const TwinScene& scene, const TwinFaceView& view, const TwinRow& row, TwinInterval part)
      : rows_(scene.cell_rows.data() + scene.faces[view.face].first_cell_row), part_(part), end_(part.begin) {
    const TwinFace& face = scene.faces[view.face];
    u_ = v_ = {0, 0, 0, 0, part.end};
    if (face.cells_u * face.cells_v > 1) {
      const glm::dvec3 d0 = row.direction(part.begin);
      const glm::dvec3 d1 = row.direction(part.end);
      begin_weight_ = glm::dot(view.grid_n, d0);
      end_weight_ = glm::dot(view.grid_n, d1);
      start_axis(u_, view.grid_u, face.cells_u, d0, d1);
      start_axis(v_, view.grid_v, face.cells_v, d0, d1);
    }
  }

  /// Moves to the next piece; false when the interval is used up.
  bool next() {
    if (end_ >= part_.end) {
      return false;
    }
    element_ = element_at(u_.cell, v_.cell);
    Axis& nearer = u_.border <= v_.border ? u_ : v_;
    if (nearer.cell == nearer.last_cell) {
      end_ = part_.end;
      return true;
    }
    end_ = std::max(nearer.border, end_);
    nearer.cell += nearer.cell < nearer.last_cell ? 1 : -1;
    find_border(nearer);
    return true;
  }

  std::uint32_t element() const { return element_; }  ///< element of the current piece
  double end() const { return end_; }                 ///< where the piece ends

 private:
  // One family of parallel grid lines: at the ends of the interval the cell coordinate is value / weight.
  struct Axis {
    double begin_value, end_value;
    int cell, last_cell;
    double border;  // where the current cell ends
  };

  static int cell_of(double value, double weight, int cells) {
    if (value <= 0 || weight <= 0) {
      return 0;
    }
    const double coordinate = value / weight;
    return coordinate < cells ? static_cast<int>(coordinate) : cells - 1;
  }

  void start_axis(Axis& axis, const glm::dvec3& grid, int cells, const glm::dvec3& d0,
                  const glm::dvec3& d1) const {
    if (cells == 1) {
      return;
    }
    axis.begin_value = glm::dot(grid, d0);
    axis.end_value = glm::dot(grid, d1);
    axis.cell = cell_of(axis.begin_value, begin_weight_, cells);
    axis.last_cell = cell_of(axis.end_value, end_weight_, cells);
    find_border(axis);
  }

  // The line between cell k - 1 and k is the zero of value - k weight, which is linear along the row.
  void find_border(Axis& axis) const {
    if (axis.cell == axis.last_cell) {
      axis.border = part_.end;
      return;
    }
    const int k = axis.cell < axis.last_cell ? axis.cell + 1 : axis.cell;
    const double a = std::fabs(axis.begin_value - k * begin_weight_);
    const double b = std::fabs(axis.end_value - k * end_weight_);
    axis.border = part_.begin + (a + b > 0 ? (part_.end - part_.begin) * (a / (a + b)) : 0.0);
  }

  std::uint32_t element_at(int u, int v) const {
    const CellRow& row = rows_[v];
    const int cell = std::clamp(u, static_cast<int>(row.first_cell), static_cast<int>(row.last_cell));
    return static_cast<std::uint32_t>(row.first_element + cell - row.first_cell);
  }

  const CellRow* rows_;
  TwinInterval part_;
  double begin_weight_ = 1, end_weight_ = 1;
  Axis u_, v_;
  std::uint32_t element_ = 0;
  double end_;
};

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

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
      : rows_(scene.cell_rows.data() + scene.faces[view.face].first_cell_row),
        row_(row),
        part_(part),
        weight_(view.grid_n),
        end_(part.begin) {
    const TwinFace& face = scene.faces[view.face];
    u_ = v_ = {{0, 0, 0}, 0, 0, part.end};
    if (face.cells_u * face.cells_v > 1) {
      start_axis(u_, view.grid_u, face.cells_u);
      start_axis(v_, view.grid_v, face.cells_v);
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
  // One family of parallel grid lines: the cell coordinate in direction d is (grid . d) / (weight . d).
  struct Axis {
    glm::dvec3 grid;
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

  int cell_at(const glm::dvec3& grid, double x, int cells) const {
    const glm::dvec3 d = row_.direction(x);
    return cell_of(glm::dot(grid, d), glm::dot(weight_, d), cells);
  }

  void start_axis(Axis& axis, const glm::dvec3& grid, int cells) const {
    if (cells == 1) {
      return;
    }
    axis.grid = grid;
    axis.cell = cell_at(grid, part_.begin, cells);
    axis.last_cell = cell_at(grid, part_.end, cells);
    find_border(axis);
  }

  // The line between cells k - 1 and k lies in the plane of all d with (grid - k weight) . d = 0.
  void find_border(Axis& axis) const {
    if (axis.cell == axis.last_cell) {
      axis.border = part_.end;
      return;
    }
    const double k = axis.cell < axis.last_cell ? axis.cell + 1 : axis.cell;
    axis.border = std::clamp(row_.crossing(axis.grid - k * weight_), part_.begin, part_.end);
  }

  std::uint32_t element_at(int u, int v) const {
    const CellRow& row = rows_[v];
    const int cell = std::clamp(u, static_cast<int>(row.first_cell), static_cast<int>(row.last_cell));
    return static_cast<std::uint32_t>(row.first_element + cell - row.first_cell);
  }

  const CellRow* rows_;
  const TwinRow& row_;
  TwinInterval part_;
  glm::dvec3 weight_;
  Axis u_, v_;
  std::uint32_t element_ = 0;
  double end_;
};

}  // namespace fixrad::host

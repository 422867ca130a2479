// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

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
      : scene_(scene),
        rows_(scene.cell_rows.data() + scene.faces[view.face].first_cell_row),
        row_(row),
        part_(part),
        weight_(view.grid_n),
        end_(part.begin) {
    const TwinFace& face = scene.faces[view.face];
    u_ = v_ = {{0, 0, 0}, 0, 0, part.end};
    u_.grid = view.grid_u;
    v_.grid = view.grid_v;
    if (face.cells_u * face.cells_v > 1) {
      start_axis(u_, view.grid_u, face.cells_u);
      start_axis(v_, view.grid_v, face.cells_v);
    }
  }

  /// Moves to the next piece; false when the interval is used up.
  bool next() {
    if (!waiting_.empty()) {
      const Waiting further = waiting_.back();
      waiting_.pop_back();
      descend(further.side, {end_, further.end});
      return true;
    }
    if (end_ >= part_.end) {
      return false;
    }
    const double begin = end_;
    const std::uint32_t cell = cell_number(u_.cell, v_.cell);
    Axis& nearer = u_.border <= v_.border ? u_ : v_;
    if (nearer.cell == nearer.last_cell) {
      end_ = part_.end;
    } else {
      end_ = std::max(nearer.border, end_);
      nearer.cell += nearer.cell < nearer.last_cell ? 1 : -1;
      find_border(nearer);
    }
    element_ = cell;
    if (!scene_.roots.empty()) {
      descend(scene_.roots[cell], {begin, end_});
    }
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

  struct Waiting {
    std::uint16_t side;
    double end;
  };

  std::uint32_t cell_number(int u, int v) {
    const CellRow& row = rows_[v];
    corner_u_ = std::clamp(u, static_cast<int>(row.first_cell), static_cast<int>(row.last_cell));
    for (corner_v_ = v; corner_v_ > 0 && rows_[corner_v_ - 1].first_element == row.first_element;) {
      --corner_v_;
    }
    return static_cast<std::uint32_t>(row.first_element + corner_u_ - row.first_cell);
  }

  // To the element that holds the beginning of `part`; the far sides of the cuts on the way wait.
  void descend(std::uint16_t side, TwinInterval part) {
    while (side < kLeaf) {
      const Cut& cut = scene_.cuts[side];
      const glm::dvec3 line =
          static_cast<double>(cut.a) * (u_.grid - static_cast<double>(corner_u_) * weight_) +
          static_cast<double>(cut.b) * (v_.grid - static_cast<double>(corner_v_) * weight_) +
          static_cast<double>(cut.c) * weight_;
      const bool begins_left = glm::dot(line, row_.direction(part.begin)) >= 0;
      const bool ends_left = glm::dot(line, row_.direction(part.end)) >= 0;
      side = begins_left ? cut.left : cut.right;
      if (begins_left != ends_left) {
        waiting_.push_back({begins_left ? cut.right : cut.left, part.end});
        part.end = std::clamp(row_.crossing(line), part.begin, part.end);
      }
    }
    element_ = static_cast<std::uint32_t>(side - kLeaf);
    end_ = part.end;
  }

  const TwinScene& scene_;
  const CellRow* rows_;
  const TwinRow& row_;
  TwinInterval part_;
  glm::dvec3 weight_;
  Axis u_, v_;
  int corner_u_ = 0, corner_v_ = 0;  // of the current cell, grid coordinates
  std::uint32_t element_ = 0;
  double end_;
  std::vector<Waiting> waiting_;
};

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "host_sim/meshing/convex_faces.h"
#include "host_sim/meshing/polygon2d.h"
#include "host_sim/meshing/quantise.h"

namespace fixrad::host {

/// The affine frame of a face: grid point = origin + s * axis_u + t * axis_v, the face within 0 <= s, t <= 1
/// (to a grid unit). Integers, since the core takes them as they are.
struct FaceFrame {
  glm::ivec3 origin{0}, axis_u{0}, axis_v{0};
  glm::dvec3 normal{0.0};
  glm::dvec3 height{0.0};  ///< a point of the face's plane
  Polygon2d outline;       ///< the face's corners in (s, t)

  glm::dvec3 to_grid(glm::dvec2 st) const;  ///< a point of the plane, grid units
  glm::dvec2 to_frame(glm::dvec3 grid_point) const;
  double unit_area() const;  ///< square grid units of the unit parallelogram
};

/// Axes along two edges for parallelograms and triangles, else along the longest edge and at right angles to
/// it.
FaceFrame make_frame(const QuantisedVertices& vertices, const ConvexFace& face);

/// An element inside its face: the part of the outline in its range of cells (slivers at the border
/// included), or a part of that.
struct CellElement {
  int u, v;           ///< its cell
  Polygon2d outline;  ///< convex, in (s, t)
  int depth = 0;      ///< cuts between it and its cell
};

/// A cut through a cell as the core has it (fixrad::Cut); a side is an element of the face, or -1 - the index
/// of a further cut.
struct CellCut {
  int a, b, c;
  int left, right;
};

/// The elements of one face on a grid of cells_u x cells_v.
struct FaceElements {
  int cells_u = 1, cells_v = 1;
  std::vector<std::pair<int, int>> rows;  ///< [cells_v]: first and last cell of each row
  std::vector<int> row_first;  ///< [cells_v]: index of the row's first cell; sliver rows repeat a neighbour's
  std::vector<CellElement> elements;  ///< row by row; the parts that cuts have made come after
  std::vector<int> roots;             ///< [cells], a side as in CellCut; empty while no cell is cut
  std::vector<CellCut> cuts;

  std::size_t cell_count() const { return roots.empty() ? elements.size() : roots.size(); }
};

/// Cuts a face. Cells of less than a fifth of a whole one join their neighbour in the row; so do rows.
FaceElements cut_face(const FaceFrame& frame, int cells_u, int cells_v);

/// Numbers of cells for square-ish elements of size `h` (grid units), at least `least` and at most 100 along
/// an axis.
std::pair<int, int> cells_for_size(const FaceFrame& frame, double h, int least);

}  // namespace fixrad::host

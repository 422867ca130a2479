// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/scene/scene.h"

namespace fixrad {

/// Corners of elements are cut to 1/64 of a grid unit; an outline's corners are exact.
constexpr int kFineLog2 = 6;
constexpr int32_t kFineScale = 1 << kFineLog2;

/// A convex planar polygon, counter-clockwise seen from the lit side; 1/64 grid unit, 0 .. 2^20. An outline
/// of kMaxCorners gains one corner for each of the four lines of a cell and for each cut through it.
struct Polygon {
  static constexpr int kMost = kMaxCorners + 4 + kMostCuts;
  Vec3 corner[kMost];
  int count;
};

/// A point of the scene, quarters of a grid unit, in the unit of polygons.
inline Vec3 fine_point(Vec3 quarters) {
  constexpr int32_t kFactor = kFineScale / kEyeScale;
  return {quarters.x * kFactor, quarters.y * kFactor, quarters.z * kFactor};
}

/// The outline of a face. Cost: a read a corner.
void face_outline(const Scene& scene, const Face& face, Polygon& polygon);

/// Where one element is: rows and columns of its face's grid, ends not included, and its way through the cuts
/// of that cell. Cells left out at the border of the face are part of the outermost ones.
struct ElementCells {
  uint16_t element;
  uint8_t first_u, end_u, first_v, end_v;
  uint8_t u;      ///< the cell's own number in its row
  uint8_t cuts;   ///< on the way to the element
  uint16_t root;  ///< where the way begins, a side as in Cut
  uint16_t way;   ///< bit kMostCuts - 1 - i: at the i-th cut, 0 to the left, 1 to the right
};

/// Walks the elements of a face, row by row, and those of a cell from left to right of its cuts.
///
///     for (ElementCellWalk walk(scene, face); walk.next();) use(walk.cells());
///
/// Rows of the grid that repeat the one before are slivers of the same elements. Cost: a read a row.
class ElementCellWalk {
 public:
  ElementCellWalk(const Scene& scene, const Face& face) : scene_(scene), face_(face) {}

  bool next();
  const ElementCells& cells() const { return cells_; }

 private:
  bool next_row();
  void enter_cell();
  void enter_element();

  const Scene& scene_;
  const Face& face_;
  ElementCells cells_ = {0, 0, 0, 0, 0, 0, 0, kLeaf, 0};
  CellRow row_ = {0, 1, 0};
  int column_ = 1;
};

/// The polygon of an element: the face's outline between the lines of its cells, of which the outermost are
/// open, and on its side of the cell's cuts. Count 0 where nothing is left. Neighbours are cut at the same
/// points but for 1/64 unit. Cost: up to four clips of up to 12 corners, and one a cut; a corner is three
/// 64-bit products (at a cut six, and two 64-bit divisions), a new corner three divisions.
void element_polygon(const Scene& scene, const Face& face, const ElementCells& cells, Polygon& polygon);

/// A point of a face's plane in the coordinates of an element's cell, as in Cut: Q16.
struct CellPoint {
  int32_t u, v;
};
CellPoint cell_point(const Face& face, const ElementCells& cells, const Vec3& point);

/// What a further cut leaves of the polygon of an element to its left, or to its right. Cost: a clip.
void cut_polygon(const Face& face, const ElementCells& cells, const Cut& cut, bool is_right,
                 Polygon& polygon);

/// Area and centroid of a polygon of `face`. Cost: two cross products and 64-bit products a corner, three
/// divisions.
struct PolygonMoments {
  uint64_t area;  ///< 2^-27 square grid units; 0 for a polygon without area
  Vec3 centroid;  ///< 1/64 grid unit
};
PolygonMoments moments_of(const Face& face, const Polygon& polygon);

/// The cells of element `element` of `face`. Cost: a read a row.
ElementCells cells_of(const Scene& scene, const Face& face, uint16_t element);

/// The cells of the element of `face` that holds a point of its plane (1/64 grid unit), the nearest one for
/// points beyond the face. Cost: 8 wide products a line of the grid.
ElementCells cells_at(const Scene& scene, const Face& face, const Vec3& point);

}  // namespace fixrad

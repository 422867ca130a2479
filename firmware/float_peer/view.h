// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/vector.h"
#include "lib/form_factor/eye.h"

namespace fixrad {
namespace peer {

/// A vertex as the current eye sees it, in the eye's frame: z away from the surface. 16 bytes.
struct VertexView {
  float x, y;  ///< make_view(): from the eye, as z; then, if it is in front, of its image on the plane z = 1
  float z;     ///< from the eye, quarters of a grid unit
  uint8_t limit;  ///< the row at which `above` changes: first row not below it in front of the eye, else the
                  ///< first below
  bool is_in_front;
  bool over_horizon;  ///< z > 0

  /// Is the vertex above the plane through the eye and row `row`? One integer comparison, and the same answer
  /// for all faces that share the vertex.
  bool is_above(uint8_t row) const { return (row < limit) == is_in_front; }

  /// Points from the eye to the vertex.
  Vector direction() const { return {x, y, is_in_front ? 1.0f : z}; }
};

constexpr uint8_t kNoEdge = 0xff;

/// Where an edge of a face crosses the row at y: x = at_zero + slope y, both on the plane z = 1.
struct EdgeCursor {
  float at_zero, slope;

  float at(float y) const { return at_zero + slope * y; }
};

/// A linear function over the directions (x, y, 1), for one row: slope x + at_row.
struct RowFunction {
  float slope, at_row;

  float operator()(float x) const { return slope * x + at_row; }
};

/// The row at y of f . (x, y, 1).
inline RowFunction on_row(Vector f, float y) {
  return {f.x, f.y * y + f.z};
}

/// A face as the current eye sees it. 76 bytes.
struct FaceView {
  Vector depth;           ///< 1/depth, linear in the direction
  Vector u, v;            ///< u / depth is the cell coordinate; only if has_u, has_v
  RowFunction row_depth;  ///< `depth` on the current row
  EdgeCursor left, right;
  uint16_t first_corner, first_cell_row;   ///< of the face
  uint8_t corner_count, cells_u, cells_v;  ///< of the face
  uint8_t left_edge, right_edge;           ///< which edges the cursors are on, or kNoEdge
  uint8_t begin_row, end_row;              ///< rows that it may cross
  uint8_t change_row;                      ///< from here on other edges cross
  bool is_back;                            ///< its back is seen: it blocks and is black

  bool has_u() const { return cells_u > 1; }
  bool has_v() const { return cells_v > 1; }
};

/// One visible interval of a row: from start to the start of the next one.
struct Span {
  float start;    ///< on the plane z = 1
  uint16_t view;  ///< index into views, or kNothing
  uint16_t next;  ///< index into the pool, or kNoSpan
};

constexpr uint16_t kNothing = 0xffff;
constexpr uint16_t kNoSpan = 0xffff;

/// Working memory of the engine; the arrays belong to the solver's storage.
struct Workspace {
  VertexView* vertices;  ///< [vertex_count]
  FaceView* views;       ///< [face_count]
  Span* spans;           ///< [span_capacity]
  uint16_t span_capacity;
  uint16_t view_count;
};

/// Prepares the view from `eye`: offsets of all vertices, planes of all faces that can be seen or whose backs
/// take part; their grids too, unless nobody will ask for elements. Cost: 9 products a
/// vertex, 15 a face and as many a grid axis, two divisions a face.
void make_view(const Scene& scene, const EyePoint& eye, Backs backs, bool grids, Workspace& work);

}  // namespace peer
}  // namespace fixrad

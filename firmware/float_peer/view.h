// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/vector.h"
#include "lib/form_factor/eye.h"

namespace fixrad {
namespace peer {

/// Half-spaces through the eye that the current side of the hemicube lies outside of, one bit each.
enum Outside : uint8_t {
  kOutsideBehind = 1,
  kOutsideRight = 2,
  kOutsideLeft = 4,
  kAboveRows = 8,
  kBelowRows = 16
};

/// A vertex as the current eye sees it, in the axes of the current side of the hemicube. 24 bytes.
struct VertexView {
  Vector offset;  ///< from the eye, quarters of a grid unit
  float px, py;   ///< its image on the side, pixels from the middle; only in front of the eye
  uint8_t limit;  ///< the row at which `above` changes: first row not below it in front of the eye, else the
                  ///< first below
  uint8_t outside;
  bool over_horizon;  ///< in the axes of the top, z > 0

  bool in_front() const { return (outside & kOutsideBehind) == 0; }
  /// Is the vertex above the plane through the eye and row `row`? One integer comparison, and the same answer
  /// for all faces that share the vertex.
  bool is_above(uint8_t row) const { return (row < limit) == in_front(); }
};

constexpr uint8_t kNoEdge = 0xff;

/// Where an edge of a face crosses the current row, stepped from row to row.
struct EdgeCursor {
  float x, step;  ///< pixels from the middle
};

/// A linear function over the directions of a side: its value along a row is slope.x x + at_row, which is
/// stepped by slope.y from row to row.
struct RowFunction {
  Vector slope;
  float at_row;

  float operator()(float x) const { return slope.x * x + at_row; }
};

/// A face as the current eye sees it. 80 bytes.
struct FaceView {
  RowFunction depth;  ///< 1/depth
  RowFunction u, v;   ///< u(x) / depth(x) is the cell coordinate; only if has_u, has_v
  EdgeCursor left, right;
  uint16_t first_corner, first_cell_row;   ///< of the face
  uint8_t corner_count, cells_u, cells_v;  ///< of the face
  uint8_t left_edge, right_edge;           ///< which edges the cursors are on, or kNoEdge
  uint8_t begin_row, end_row;              ///< rows of the current side that it may cross
  uint8_t change_row;                      ///< from here on other edges cross
  bool is_back;                            ///< its back is seen: it blocks and is black

  bool has_u() const { return cells_u > 1; }
  bool has_v() const { return cells_v > 1; }
};

/// One visible interval of a row: from start to the start of the next one.
struct Span {
  float start;    ///< pixels from the middle
  uint16_t view;  ///< index into views, or kNothing
  uint16_t next;  ///< index into the pool, or kNoSpan
};

constexpr uint16_t kNothing = 0xffff;
constexpr uint16_t kNoSpan = 0xffff;

/// Working memory of the hemicube; the arrays belong to the solver's storage.
struct Workspace {
  VertexView* vertices;  ///< [vertex_count]
  FaceView* views;       ///< [face_count]
  Span* spans;           ///< [span_capacity]
  uint16_t span_capacity;
  uint16_t view_count;
};

/// Prepares the view from `eye`: offsets of all vertices, planes of all faces that can be seen or, where
/// `back_faces` asks for it, block; their grids too, unless nobody will ask for elements. Cost: 9 products a
/// vertex, 15 a face and as many a grid axis, two divisions a face.
void make_view(const Scene& scene, const EyePoint& eye, bool back_faces, bool grids, Workspace& work);

}  // namespace peer
}  // namespace fixrad

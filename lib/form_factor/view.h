// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/eye.h"
#include "lib/scene/scene.h"

namespace fixrad {

/// A vertex as a direction from the eye in the axes of the current side of the hemicube, scaled by its own
/// power of two: Q0 in [-2^14, 2^14].
struct Direction {
  int16_t x, y, z;
  int16_t
      height;  ///< floor(R y / z) cut to [-R - 1, R]: rows up to here have it above them; kBehind if z <= 0
};

constexpr int16_t kBehind = -32768;

constexpr uint8_t kNoEdge = 0xff;

/// Where one edge of a face crosses the rows of a hemicube side: at (half_width + base + y step) / (2
/// half_width) of the row, in front of the eye if half_width > 0. Kept from row to row, with the reciprocal
/// of half_width, so that a row needs no division.
struct EdgeCursor {
  int32_t base, step;
  int32_t half_width;   ///< 0: the edge meets the rows behind the eye
  uint16_t reciprocal;  ///< 2^31 / (half_width scaled to 16 bits)
  int8_t shift;         ///< that brings a numerator to 15 bits
  uint8_t edge;         ///< which one, or kNoEdge
};

/// A face as the current eye sees it; 92 bytes. Vectors are in the axes of the
/// current side of the hemicube.
struct FaceView {
  Vec3 grid_u, grid_v,
      grid_n;              ///< u = (grid_u . d) / (grid_n . d) is the cell coordinate in direction d; < 2^18
  int32_t depth_distance;  ///< distance of the plane, Q14 quarters of a grid unit, > 0
  EdgeCursor left, right;
  int16_t depth_normal[3];  ///< Q14; 1/depth in direction d is (depth_normal . d) / depth_distance
  uint16_t face;
  uint16_t first_corner;                   ///< of the face, kept here because every row needs them
  uint16_t first_cell_row;                 ///< of the face
  uint8_t corner_count, cells_u, cells_v;  ///< of the face
  uint8_t first_row, last_row;             ///< rows of the current side that it crosses; first > last: none
  bool is_back;                            ///< its back is seen: it blocks and is black
};

/// One visible interval of a row: from start to the start of the next one.
struct Span {
  uint16_t start;  ///< 0..kRowEnd
  uint16_t view;   ///< index into views, or kNothing
  uint16_t next;   ///< index into the pool, or kNoSpan
};

/// Vertex of corner `k` of the viewed face.
inline uint16_t view_corner(const Scene& scene, const FaceView& view, int k) {
  return flash_read(scene.corners, static_cast<unsigned>(view.first_corner + k));
}

constexpr uint16_t kNothing = 0xffff;
constexpr uint16_t kNoSpan = 0xffff;

/// One pixel of the item buffer.
struct Item {
  uint16_t slot;  ///< element, kBackSlot or kEscapedSlot
  uint16_t view;
};

/// Working memory of the form-factor engines; the arrays belong to the solver's storage.
struct Workspace {
  Direction* directions;  ///< [vertex_count]
  FaceView* views;        ///< [face_count]
  Span* spans;            ///< [span_capacity]
  Item* items;            ///< [item_capacity], `pixels` only
  uint32_t item_capacity;
  uint16_t span_capacity;
  uint16_t view_count;
  uint16_t span_high_water;  ///< most spans that any row has needed
  uint32_t gaps_closed;      ///< uncovered intervals of closed scenes that were given to a neighbour
};

/// Prepares the view from `eye`: directions to all vertices, planes and grids of all faces that can be seen
/// or, where `back_faces` asks for it, block. Cost: 9 products a vertex, about 60 a face.
void make_view(const Scene& scene, const EyePoint& eye, bool back_faces, Workspace& work);

}  // namespace fixrad

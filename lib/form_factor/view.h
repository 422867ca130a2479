// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/eye.h"
#include "lib/form_factor/row_plane.h"
#include "lib/scene/scene.h"

namespace fixrad {

/// A vertex as a direction from the eye in the axes of the current side of the hemicube (of lunes: of the
/// eye's frame), scaled by its own power of two: Q0 in [-2^14, 2^14].
struct Direction {
  int16_t x, y, z;
  RowMask above;  ///< rows of the current band whose plane has the vertex above it
};

inline Vec3 vec(const Direction& d) {
  return {d.x, d.y, d.z};
}

/// An edge of a face that crosses rows of the current band in front of the eye, kept from row to row.
struct EdgeCursor {
  Vec3 normal;   ///< lower x upper end, block-normalised to 2^19; x < 0: in front of the eye
  RowMask rows;  ///< of the band that it crosses
};

/// A face as the current eye sees it; 92 bytes, what every row asks for first: Thumb code reaches no further
/// in one instruction. Vectors are in the axes of the current side.
struct FaceView {
  RowMask rows;           ///< of the current band that it may cover a part of
  RowMask ragged;         ///< of these, where rounding has bent it: more than two edges cross
  uint16_t first_corner;  ///< of the face, kept here because every row needs them
  uint8_t corner_count;   ///< of the face
  bool is_back;           ///< its back is seen: it blocks and is black
  EdgeCursor left, right;
  int16_t depth[3];          ///< normal / distance as a block of three 14-bit numbers: 1/depth in direction d
  uint8_t depth_shift;       ///< is (depth . d) / 2^depth_shift, in a unit common to all faces; 0: not made
  uint8_t cells_u, cells_v;  ///< of the face
  uint16_t first_cell_row;   ///< of the face
  uint16_t face;
  Vec3 grid_u, grid_v,
      grid_n;  ///< u = (grid_u . d) / (grid_n . d) is the cell coordinate in direction d; < 2^18
};

/// One visible interval of a row: from start to the start of the next one.
struct alignas(4) Span {
  int16_t start;  ///< 0..kRowEnd
  uint16_t view;  ///< index into views, or kNothing
};

/// Vertex of corner `k` of the viewed face.
inline uint16_t view_corner(const Scene& scene, const FaceView& view, int k) {
  return flash_read(scene.corners, view.first_corner + static_cast<unsigned>(k));
}

constexpr uint16_t kNothing = 0xffff;

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
  uint16_t span_high_water;  ///< most spans that any row has needed, the one that ends it included
  uint32_t gaps_closed;      ///< uncovered intervals of closed scenes that were given to a neighbour
};

/// Prepares the view from `eye`: directions to all vertices, and all faces that can be seen or whose backs
/// take part, without their depth. Cost: 9 products a vertex, 3 a face.
void make_view(const Scene& scene, const EyePoint& eye, Backs backs, Workspace& work);

/// Whether what is seen of a face is to be cut into elements.
inline bool has_grid(const Scene& scene, const FaceView& view) {
  return view.cells_u * view.cells_v > 1 || scene.roots != nullptr;
}

/// Adds the depth of the faces in view, in the axes that make_view() leaves. Only a view in which faces meet
/// on a row needs it: where nothing hides anything, none does. Cost: 15 products and a division a face.
void make_depths(const Scene& scene, const EyePoint& eye, Workspace& work);

/// Adds the element grids of the faces in view. Cost: 50 products a face.
void make_grids(const Scene& scene, const EyePoint& eye, Workspace& work);

}  // namespace fixrad

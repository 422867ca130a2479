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

/// How far the view under way has come; all zeros where none is. Engines leave one in the middle when the
/// budget of their workspace is used up and go on with it at the next call. What else they need then they
/// make again or find in the views.
struct ViewCursor {
  uint16_t next;      ///< 0: not begun; else one more than the steps done: rows, or (pair by pair) faces
  uint16_t elements;  ///< pair by pair: those done of the next face
  uint32_t sum;       ///< running sum of delta form factors (pair by pair: of factors) so far
  union {
    uint32_t hidden;  ///< of it, what hidden_share() looks for; rays: what hidden_share() found
    int32_t largest;  ///< contours: the largest factor
  };
  union {
    uint32_t back;          ///< rays: of it, on back faces
    uint16_t largest_slot;  ///< contours: of the element with the largest factor
  };

  /// Steps done of a view that has begun.
  int done() const { return static_cast<int>(next) - 1; }
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
  ViewCursor at;
  uint32_t budget;  ///< one more than the units of work that may still be done; 0: no limit
};

/// A unit of work is what docs/bounded_time.md bounds: a row of a hemisphere (with the beginning of a band or
/// side that it opens), the beginning of a view, a pair of elements, kStretch elements looked through, the
/// beginning of a pass, or the booking of a shot. Whoever does one asks is_used_up() before and says spend()
/// after.
inline bool is_used_up(const Workspace& work) {
  return work.budget == 1;
}
inline void spend(Workspace& work) {
  work.budget -= work.budget > 1 ? 1u : 0u;
}

/// Elements or sources looked through for one unit. Says that the one before `next` has been.
constexpr uint16_t kStretch = 16;
inline void spend_on_stretch(Workspace& work, uint16_t next) {
  if (next % kStretch == 0) {
    spend(work);
  }
}

/// Gives up the view under way, if there is one.
inline void forget_view(Workspace& work) {
  work.at = {};
}

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

// SPDX-License-Identifier: MIT
#include "firmware/float_peer/scanline.h"

namespace fixrad {
namespace peer {
namespace {

// Nearer to the plane of the eye than this (quarters of a grid unit) a vertex counts as behind it.
constexpr float kInFront = 1.0f / 64;

// An end that lies off the row wherever the row is.
constexpr float kFarOff = 1.0e30f;

// From the axes of one side to those of the next: the top's (x, y, z) become (y, z, x); from then on a
// quarter turn about the normal, (-z, y, x).
void turn_to(uint8_t side, Vector& v) {
  v = side == 1 ? Vector{v.y, v.z, v.x} : Vector{-v.z, v.y, v.x};
}

float magnitude(float a) {
  return __builtin_fabsf(a);
}

uint8_t outside_rows(const VertexView& v, uint8_t bottom, uint8_t rows) {
  const bool above_first = v.is_above(bottom);
  const bool above_last = v.is_above(static_cast<uint8_t>(rows - 1));
  return above_first && above_last ? kAboveRows : (!above_first && !above_last ? kBelowRows : 0);
}

// Row r lies at r + 1/2 - half, so a vertex at height t is above the rows r < t + half + 1/2.
uint8_t row_limit(float t, uint8_t half) {
  const int32_t limit = static_cast<int32_t>(t + (static_cast<float>(half) + 0.5f));
  return static_cast<uint8_t>(limit < 0 ? 0 : (limit > 2 * half ? 2 * half : limit));
}

void project(VertexView& v, uint8_t bottom, uint8_t half) {
  const Vector p = v.offset;
  const float size = static_cast<float>(half);
  if (p.z > kInFront) {
    const float s = size / p.z;
    v.px = p.x * s;
    v.py = p.y * s;
    v.limit = row_limit(v.py, half);
    v.outside = magnitude(v.px) <= size ? 0 : (v.px > 0.0f ? kOutsideRight : kOutsideLeft);
  } else {
    const float depth = magnitude(p.z);
    v.limit = magnitude(p.y) < depth ? row_limit(size * p.y / p.z, half)
                                     : static_cast<uint8_t>(p.y > 0.0f ? 0 : 2 * half);
    const uint8_t sideways =
        magnitude(p.x) < depth ? kOutsideRight | kOutsideLeft : (p.x > 0.0f ? kOutsideRight : kOutsideLeft);
    v.outside = static_cast<uint8_t>(kOutsideBehind | sideways);
  }
  v.outside = static_cast<uint8_t>(v.outside | outside_rows(v, bottom, static_cast<uint8_t>(2 * half)));
}

const VertexView& corner(const Scene& scene, const VertexView* vertices, const FaceView& view, uint8_t k) {
  return vertices[read(scene.corners, static_cast<unsigned>(view.first_corner) + k)];
}

// A face that reaches behind the eye may cross any row.
void find_rows(const Scene& scene, uint8_t bottom, uint8_t rows, const VertexView* vertices, FaceView& view) {
  uint8_t all = 0xff, any = 0, lowest = rows, highest = 0;
  for (uint8_t k = 0; k < view.corner_count; ++k) {
    const VertexView& v = corner(scene, vertices, view, k);
    all = static_cast<uint8_t>(all & v.outside);
    any = static_cast<uint8_t>(any | v.outside);
    lowest = v.limit < lowest ? v.limit : lowest;
    highest = v.limit > highest ? v.limit : highest;
  }
  const bool reaches_behind = (any & kOutsideBehind) != 0;
  view.begin_row = reaches_behind || lowest < bottom ? bottom : lowest;
  view.end_row = all != 0 ? 0 : (reaches_behind ? rows : highest);
}

void start_function(float y, float size, RowFunction& f) {
  f.at_row = f.slope.y * y + f.slope.z * size;
}

void start_face(uint8_t half, FaceView& view) {
  view.left_edge = view.right_edge = kNoEdge;
  view.change_row = view.begin_row;
  const float size = static_cast<float>(half);
  const float y = static_cast<float>(view.begin_row) + (0.5f - size);
  start_function(y, size, view.depth);
  if (view.has_u()) {
    start_function(y, size, view.u);
  }
  if (view.has_v()) {
    start_function(y, size, view.v);
  }
}

void step_face(FaceView& view) {
  view.left.x += view.left.step;
  view.right.x += view.right.step;
  view.depth.at_row += view.depth.slope.y;
  if (view.has_u()) {
    view.u.at_row += view.u.slope.y;
  }
  if (view.has_v()) {
    view.v.at_row += view.v.slope.y;
  }
}

// With both ends in front the edge runs between their images, measured from the end that is farther from the
// plane of the eye, whose image is not far off. Otherwise its plane through the eye is cut with the row; it
// meets the row in front of the eye if `reach` is above 0, else the face leaves the row at `behind`.
EdgeCursor start_edge(const VertexView& below, const VertexView& above, float y, float size, float behind) {
  if (below.in_front() && above.in_front()) {
    const VertexView& anchor = below.offset.z > above.offset.z ? below : above;
    const float step = (above.px - below.px) / (above.py - below.py);
    return {anchor.px + (y - anchor.py) * step, step};
  }
  const Vector e = cross(below.offset, above.offset);
  if (!(e.x < 0.0f)) {
    return {behind, 0.0f};
  }
  const float s = -1.0f / e.x;
  const float step = e.y * s;
  return {e.z * s * size + y * step, step};
}

struct Crossings {
  EdgeCursor left, right;
  uint8_t left_edge, right_edge;
  uint8_t lefts, rights;
};

// Of several edges on one side the outermost counts.
void meet_edge(bool is_left, uint8_t edge, const EdgeCursor& met, Crossings& found) {
  if (is_left) {
    if (found.lefts++ == 0 || met.x < found.left.x) {
      found.left = met;
      found.left_edge = edge;
    }
  } else if (found.rights++ == 0 || met.x > found.right.x) {
    found.right = met;
    found.right_edge = edge;
  }
}

// Seen from the eye with z away from it, a front face runs clockwise in (x, y): its rising edges are on the
// left. An edge that the face keeps goes on as it is. Where rounding has bent a face, the next row asks
// again.
void find_edges(const Scene& scene, uint8_t row, float size, const VertexView* vertices, FaceView& view) {
  Crossings found = {{kFarOff, 0.0f}, {-kFarOff, 0.0f}, kNoEdge, kNoEdge, 0, 0};
  const float y = static_cast<float>(row) + (0.5f - size);
  uint8_t change = 0xff;
  uint8_t from = static_cast<uint8_t>(view.corner_count - 1);
  const VertexView* a = &corner(scene, vertices, view, from);
  for (uint8_t k = 0; k < view.corner_count; from = k++) {
    const VertexView* b = &corner(scene, vertices, view, k);
    change = b->limit > row && b->limit < change ? b->limit : change;
    const bool b_above = b->is_above(row);
    if (a->is_above(row) != b_above) {
      const bool is_left = b_above != view.is_back;
      const bool is_kept = (is_left ? view.left_edge : view.right_edge) == from;
      const EdgeCursor& kept = is_left ? view.left : view.right;
      meet_edge(is_left, from,
                is_kept
                    ? kept
                    : start_edge(b_above ? *a : *b, b_above ? *b : *a, y, size, is_left ? -kFarOff : kFarOff),
                found);
    }
    a = b;
  }
  view.change_row = found.lefts > 1 || found.rights > 1 ? static_cast<uint8_t>(row + 1) : change;
  view.left = found.left;
  view.right = found.right;
  view.left_edge = found.left_edge;
  view.right_edge = found.right_edge;
  if (found.left.x == -kFarOff && found.right.x == kFarOff) {  // both meet the row behind the eye
    view.left = {kFarOff, 0.0f};
    view.left_edge = view.right_edge = kNoEdge;
  }
}

}  // namespace

void enter_side(const Scene& scene, uint8_t side, uint8_t half, Workspace& work) {
  const uint8_t bottom = first_row(side, half);
  for (uint16_t i = 0; i < scene.vertex_count; ++i) {
    if (side != kTop) {
      turn_to(side, work.vertices[i].offset);
    }
    project(work.vertices[i], bottom, half);
  }
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    if (side != kTop) {
      turn_to(side, view.depth.slope);
      if (view.has_u()) {
        turn_to(side, view.u.slope);
      }
      if (view.has_v()) {
        turn_to(side, view.v.slope);
      }
    }
    find_rows(scene, bottom, static_cast<uint8_t>(2 * half), work.vertices, view);
    if (view.begin_row < view.end_row) {
      start_face(half, view);
    }
  }
}

Interval face_interval(const Scene& scene, uint8_t row, float size, const VertexView* vertices,
                       FaceView& view) {
  if (row != view.begin_row) {
    step_face(view);
  }
  if (row == view.change_row) {
    find_edges(scene, row, size, vertices, view);
  }
  return {view.left.x < -size ? -size : view.left.x, view.right.x > size ? size : view.right.x};
}

}  // namespace peer
}  // namespace fixrad

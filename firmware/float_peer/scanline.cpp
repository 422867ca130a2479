// SPDX-License-Identifier: MIT
#include "firmware/float_peer/scanline.h"

namespace fixrad {
namespace peer {
namespace {

// Nearer to the plane of the eye than this (quarters of a grid unit) a vertex counts as behind it.
constexpr float kInFront = 1.0f / 64;

// An end that lies off the row wherever the row is.
constexpr float kFarOff = 1.0e30f;

float magnitude(float a) {
  return __builtin_fabsf(a);
}

// How many rows are below height t.
uint8_t rows_below(const LuneTable& table, float t) {
  const uint8_t half = table.size / 2;
  const float distance = magnitude(t);
  uint8_t low = 0, high = half;
  while (low < high) {
    const uint8_t middle = static_cast<uint8_t>((low + high) / 2);
    if (flash_at(table.lunes, middle).tangent < distance) {
      low = static_cast<uint8_t>(middle + 1);
    } else {
      high = middle;
    }
  }
  return static_cast<uint8_t>(t < 0.0f ? half - low : half + low);
}

void project(const LuneTable& table, float highest, VertexView& v) {
  v.is_in_front = v.z > kInFront;
  if (v.is_in_front) {
    const float s = 1.0f / v.z;
    v.x *= s;
    v.y *= s;
    v.limit = rows_below(table, v.y);
    return;
  }
  const float depth = magnitude(v.z);
  if (magnitude(v.y) < highest * depth) {
    v.limit = rows_below(table, -v.y / depth);
  } else {
    v.limit = v.y > 0.0f ? static_cast<uint8_t>(0) : table.size;
  }
}

const VertexView& corner(const Scene& scene, const VertexView* vertices, const FaceView& view, uint8_t k) {
  return vertices[flash_read(scene.corners, static_cast<unsigned>(view.first_corner) + k)];
}

// A face that reaches behind the eye may cross any row.
void find_rows(const Scene& scene, uint8_t rows, const VertexView* vertices, FaceView& view) {
  bool any_in_front = false, any_behind = false;
  uint8_t lowest = rows, highest = 0;
  for (uint8_t k = 0; k < view.corner_count; ++k) {
    const VertexView& v = corner(scene, vertices, view, k);
    (v.is_in_front ? any_in_front : any_behind) = true;
    lowest = v.limit < lowest ? v.limit : lowest;
    highest = v.limit > highest ? v.limit : highest;
  }
  view.begin_row = any_behind ? 0 : lowest;
  view.end_row = any_in_front ? (any_behind ? rows : highest) : 0;
  view.change_row = view.begin_row;
  view.left_edge = view.right_edge = kNoEdge;
}

// With both ends in front the edge runs between their images, measured from the end that is farther from the
// plane of the eye, whose image is not far off. Otherwise its plane through the eye is cut with the rows; it
// meets them in front of the eye if its normal's x is below 0, else the face leaves the row at `behind`.
EdgeCursor start_edge(const VertexView& below, const VertexView& above, float behind) {
  if (below.is_in_front && above.is_in_front) {
    const VertexView& anchor = below.z > above.z ? below : above;
    const float slope = (above.x - below.x) / (above.y - below.y);
    return {anchor.x - anchor.y * slope, slope};
  }
  const Vector e = cross(below.direction(), above.direction());
  if (!(e.x < 0.0f)) {
    return {behind, 0.0f};
  }
  const float s = -1.0f / e.x;
  return {e.z * s, e.y * s};
}

struct Crossings {
  EdgeCursor left, right;
  uint8_t left_edge, right_edge;
  uint8_t lefts, rights;
};

// Of several edges on one side the outermost counts.
void meet_edge(bool is_left, uint8_t edge, float y, const EdgeCursor& met, Crossings& found) {
  if (is_left) {
    if (found.lefts++ == 0 || met.at(y) < found.left.at(y)) {
      found.left = met;
      found.left_edge = edge;
    }
  } else if (found.rights++ == 0 || met.at(y) > found.right.at(y)) {
    found.right = met;
    found.right_edge = edge;
  }
}

// Seen from the eye with z away from it, a front face runs clockwise in (x, y): its rising edges are on the
// left. An edge that the face keeps goes on as it is. Where rounding has bent a face, the next row asks
// again.
void find_edges(const Scene& scene, uint8_t row, float y, const VertexView* vertices, FaceView& view) {
  Crossings found = {{kFarOff, 0.0f}, {-kFarOff, 0.0f}, kNoEdge, kNoEdge, 0, 0};
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
      const float behind = is_left ? -kFarOff : kFarOff;
      meet_edge(is_left, from, y, is_kept ? kept : start_edge(b_above ? *a : *b, b_above ? *b : *a, behind),
                found);
    }
    a = b;
  }
  view.change_row = found.lefts > 1 || found.rights > 1 ? static_cast<uint8_t>(row + 1) : change;
  view.left = found.left;
  view.right = found.right;
  view.left_edge = found.left_edge;
  view.right_edge = found.right_edge;
  if (found.left.at_zero == -kFarOff && found.right.at_zero == kFarOff) {  // both meet the row behind the eye
    view.left = {kFarOff, 0.0f};
    view.left_edge = view.right_edge = kNoEdge;
  }
}

}  // namespace

void enter_rows(const Scene& scene, const LuneTable& table, Workspace& work) {
  const float highest = flash_read(table.lunes, table.size / 2 - 1u).tangent;
  for (uint16_t i = 0; i < scene.vertex_count; ++i) {
    project(table, highest, work.vertices[i]);
  }
  for (uint16_t i = 0; i < work.view_count; ++i) {
    find_rows(scene, table.size, work.vertices, work.views[i]);
  }
}

Interval face_interval(const Scene& scene, uint8_t row, float y, const VertexView* vertices, FaceView& view) {
  if (row == view.change_row) {
    find_edges(scene, row, y, vertices, view);
  }
  if (view.left_edge == kNoEdge) {
    return {0.0f, 0.0f};
  }
  const float left = view.left.at(y), right = view.right.at(y);
  return {left < -kRowEnd ? -kRowEnd : left, right > kRowEnd ? kRowEnd : right};
}

}  // namespace peer
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "lib/form_factor/scanline.h"

#include "lib/form_factor/delta_table.h"

namespace fixrad {
namespace {

// e = below x above with components cut to 20 bits: base + y step stays below 2^28 at R = 128, and the
// dividend of a crossing below 2^32.
constexpr int kEdgeBits = 20;

Vec3 vec(const Direction& d) {
  return {d.x, d.y, d.z};
}

// From the axes of one side to those of the next: the top's (x, y, z) become (y, z, x); from then on a
// quarter turn about the normal, (-z, y, x).
template <class T>
void turn_to(int side, T& x, T& y, T& z) {
  const T old_x = x;
  if (side == 1) {
    x = y;
    y = z;
  } else {
    x = static_cast<T>(-z);
  }
  z = old_x;
}

void turn_to(int side, Vec3& v) {
  turn_to(side, v.x, v.y, v.z);
}

void turn_view(int side, uint16_t vertex_count, Workspace& work) {
  for (uint16_t i = 0; i < vertex_count; ++i) {
    turn_to(side, work.directions[i].x, work.directions[i].y, work.directions[i].z);
  }
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    turn_to(side, view.depth_normal[0], view.depth_normal[1], view.depth_normal[2]);
    turn_to(side, view.grid_u);
    turn_to(side, view.grid_v);
    turn_to(side, view.grid_n);
  }
}

// Half-spaces through the eye that a hemicube side lies outside of; a face is invisible if all its corners
// are in one.
int outcode(Vec3 v, int side) {
  int code = v.z <= 0 ? 1 : 0;
  code |= v.x > v.z ? 2 : 0;
  code |= v.x < -v.z ? 4 : 0;
  code |= v.y > v.z ? 8 : 0;
  code |= (side == kTop ? v.y < -v.z : v.y <= 0) ? 16 : 0;
  return code;
}

int32_t floor_divide(int32_t a, int32_t b) {
  const int32_t q = a / b;
  return a % b != 0 && a < 0 ? q - 1 : q;
}

int32_t clamp(int32_t a, int32_t low, int32_t high) {
  return a < low ? low : (a > high ? high : a);
}

bool is_outside(const Scene& scene, int side, const Direction* directions, const FaceView& view) {
  int outside = 31;
  for (int k = 0; k < view.corner_count && outside != 0; ++k) {
    outside &= outcode(vec(directions[view_corner(scene, view, k)]), side);
  }
  return outside != 0;
}

// A vertex in front of the eye is above row r while 2 r + 1 - R <= R y / z, which gives the rows exactly.
void find_heights(uint16_t vertex_count, int resolution_log2, Direction* directions) {
  const int32_t r = static_cast<int32_t>(1) << resolution_log2;
  for (uint16_t i = 0; i < vertex_count; ++i) {
    Direction& d = directions[i];
    d.height = d.z > 0 ? static_cast<int16_t>(clamp(floor_divide(d.y * r, d.z), -r - 1, r)) : kBehind;
  }
}

bool is_above(const Direction& d, const RowPosition& at) {
  if (d.height != kBehind) {
    return at.y <= d.height;
  }
  return d.y * (static_cast<int32_t>(1) << at.resolution_log2) >= at.y * d.z;
}

// A face that reaches behind the eye may cross any row.
void find_rows(const Scene& scene, int side, int resolution_log2, const Direction* directions,
               FaceView& view) {
  const int32_t r = static_cast<int32_t>(1) << resolution_log2;
  const int32_t bottom = side == kTop ? 0 : r / 2;
  view.first_row = 1;
  view.last_row = 0;
  if (is_outside(scene, side, directions, view)) {
    return;
  }
  int32_t lowest = r, highest = -r - 1;
  for (int k = 0; k < view.corner_count; ++k) {
    const int32_t height = directions[view_corner(scene, view, k)].height;
    if (height == kBehind) {
      lowest = -r - 1;
      highest = r;
      break;
    }
    lowest = height < lowest ? height : lowest;
    highest = height > highest ? height : highest;
  }
  const int32_t first = clamp(floor_divide(lowest + r - 1, 2) + 1, bottom, r);
  const int32_t last = clamp(floor_divide(highest + r - 1, 2), -1, r - 1);
  if (first <= last) {
    view.first_row = static_cast<uint8_t>(first);
    view.last_row = static_cast<uint8_t>(last);
  }
}

// The reciprocal of an n-bit half width takes its top 16 bits, a numerator below 2^(n + 1) its top 15:
// positions come out within half a unit, the same for both faces that share the edge.
void start_edge(EdgeCursor& cursor, int resolution_log2, Vec3 below, Vec3 above) {
  Vec3 e = cross(below, above);
  const int excess = bit_length(max_magnitude(e)) - kEdgeBits;
  if (excess > 0) {
    e = scale_down(e, excess);
  }
  const int32_t r = static_cast<int32_t>(1) << resolution_log2;
  cursor.base = e.z * r;
  cursor.step = e.y;
  cursor.half_width = e.x < 0 ? -e.x * r : 0;
  if (cursor.half_width > 0) {
    const uint32_t width = static_cast<uint32_t>(cursor.half_width);
    const int bits = bit_length(width);
    const uint32_t top = bits > 16 ? width >> (bits - 16) : width << (16 - bits);
    const uint32_t reciprocal = (static_cast<uint32_t>(1) << 31) / top;
    cursor.reciprocal = static_cast<uint16_t>(reciprocal > 0xffff ? 0xffff : reciprocal);
    cursor.shift = static_cast<int8_t>(bits - 14);
  }
}

// x where an edge in front of the eye crosses the row: numerator / half_width * 2^11, in a product below
// 2^31.
int32_t crossing(const EdgeCursor& cursor, const RowPosition& at) {
  const int32_t from_left = cursor.half_width + cursor.base + at.y * cursor.step;
  if (from_left <= 0) {
    return 0;
  }
  if (from_left >= 2 * cursor.half_width) {
    return kRowEnd;
  }
  const uint32_t n = static_cast<uint32_t>(from_left);
  const uint32_t numerator = cursor.shift >= 0 ? n >> cursor.shift : n << -cursor.shift;
  return static_cast<int32_t>((numerator * cursor.reciprocal) >> 18);
}

// Ends of the covered part while the corners are walked; an end behind the eye leaves the row at its own
// border.
struct Ends {
  int32_t left, right;
  bool left_behind, right_behind;
};

void meet_edge(const RowPosition& at, bool is_left, uint8_t edge, const Direction& below,
               const Direction& above, FaceView& view, Ends& ends) {
  EdgeCursor& cursor = is_left ? view.left : view.right;
  if (cursor.edge != edge) {
    start_edge(cursor, at.resolution_log2, vec(below), vec(above));
    cursor.edge = edge;
  }
  if (cursor.half_width == 0) {
    (is_left ? ends.left_behind : ends.right_behind) = true;
    return;
  }
  const int32_t x = crossing(cursor, at);
  if (is_left) {
    ends.left = x < ends.left ? x : ends.left;
  } else {
    ends.right = x > ends.right ? x : ends.right;
  }
}

}  // namespace

void enter_side(const Scene& scene, int side, int resolution_log2, Workspace& work) {
  if (side != kTop) {
    turn_view(side, scene.vertex_count, work);
  }
  find_heights(scene.vertex_count, resolution_log2, work.directions);
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    view.left.edge = kNoEdge;
    view.right.edge = kNoEdge;
    find_rows(scene, side, resolution_log2, work.directions, view);
  }
}

// Seen from the eye with z away from it, a front face runs clockwise in (x, y): its rising edges are on the
// left.
Interval face_interval(const Scene& scene, const RowPosition& at, const Direction* directions,
                       FaceView& view) {
  Ends ends = {kRowEnd, 0, false, false};
  int from = view.corner_count - 1;
  const Direction* a = directions + view_corner(scene, view, from);
  bool a_above = is_above(*a, at);
  for (int k = 0; k < view.corner_count; ++k) {
    const Direction* b = directions + view_corner(scene, view, k);
    const bool b_above = is_above(*b, at);
    if (a_above != b_above) {
      const bool is_left = b_above != view.is_back;
      meet_edge(at, is_left, static_cast<uint8_t>(from), b_above ? *a : *b, b_above ? *b : *a, view, ends);
    }
    a = b;
    a_above = b_above;
    from = k;
  }
  if (ends.left_behind && ends.right_behind) {
    return {0, 0};
  }
  return {ends.left_behind ? 0 : ends.left, ends.right_behind ? kRowEnd : ends.right};
}

}  // namespace fixrad

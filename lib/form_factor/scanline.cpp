// SPDX-License-Identifier: MIT
#include "lib/form_factor/scanline.h"

namespace fixrad {
namespace {

// A row's |y| + z < 2^12, so normal . m stays below 2^31 for components up to 2^19.
constexpr int kEdgeBits = 19;

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

bool is_outside(const Scene& scene, int side, const Direction* directions, const FaceView& view) {
  int outside = 31;
  for (int k = 0; k < view.corner_count && outside != 0; ++k) {
    outside &= outcode(vec(directions[view_corner(scene, view, k)]), side);
  }
  return outside != 0;
}

// A vertex in front of the eye is above all rows up to some one, its opposite, behind the eye, above all that
// it is not: a search finds where the rows change.
RowMask rows_below(const Direction& d, const RowPlane* planes, int count) {
  const bool is_front = d.z > 0 || (d.z == 0 && d.y >= 0);
  const RowPlane* low = planes;
  for (int left = count; left > 0;) {
    const int half = left / 2;
    const bool is_above = d.y * low[half].z >= d.z * low[half].y;
    if (is_above == is_front) {
      low += half + 1;
      left -= half + 1;
    } else {
      left = half;
    }
  }
  const RowMask until = static_cast<RowMask>((static_cast<uint32_t>(1) << (low - planes)) - 1u);
  return is_front ? until : static_cast<RowMask>(~until);
}

void find_rows_below(const DeltaTable& table, int first, int count, uint16_t vertex_count,
                     Direction* directions) {
  RowPlane planes[kBandRows];
  for (int i = 0; i < count; ++i) {
    planes[i] = row_plane(table, first + i);
  }
  for (uint16_t i = 0; i < vertex_count; ++i) {
    directions[i].above = rows_below(directions[i], planes, count);
  }
}

// Rows that edges cross. A convex face has one rising and one falling edge on a row, or none.
void find_rows(const Scene& scene, int count, const Direction* directions, FaceView& view) {
  const uint32_t band = (static_cast<uint32_t>(1) << count) - 1u;
  RowMask rising = 0, falling = 0, ragged = 0;
  RowMask a = directions[view_corner(scene, view, view.corner_count - 1)].above;
  for (int k = 0; k < view.corner_count; ++k) {
    const RowMask b = directions[view_corner(scene, view, k)].above;
    const RowMask up = static_cast<RowMask>(b & ~a), down = static_cast<RowMask>(a & ~b);
    ragged = static_cast<RowMask>(ragged | (rising & up) | (falling & down));
    rising = static_cast<RowMask>(rising | up);
    falling = static_cast<RowMask>(falling | down);
    a = b;
  }
  view.rows = static_cast<RowMask>(rising & band);
  view.ragged = ragged;
  view.left.rows = view.right.rows = 0;
}

void start_edge(EdgeCursor& cursor, const Direction& below, const Direction& above) {
  cursor.normal = block_normalise(cross(vec(below), vec(above)), kEdgeBits);
  cursor.rows = static_cast<RowMask>(above.above & ~below.above);
}

bool is_behind(const EdgeCursor& cursor) {
  return cursor.normal.x >= 0;
}

int32_t crossing(const EdgeCursor& cursor, const RowPlane& plane) {
  const int32_t m = cursor.normal.y * plane.y + cursor.normal.z * plane.z;
  return row_crossing(cursor.normal.x, floor_shift(m, kPlaneBits), plane.fold);
}

// The edge that crosses the row upwards (walking the corners), or downwards.
void find_edge(const Scene& scene, RowMask bit, bool upwards, const Direction* directions,
               const FaceView& view, EdgeCursor& cursor) {
  const Direction* a = directions + view_corner(scene, view, view.corner_count - 1);
  for (int k = 0; k < view.corner_count; ++k) {
    const Direction* b = directions + view_corner(scene, view, k);
    const Direction* above = upwards ? b : a;
    const Direction* below = upwards ? a : b;
    if ((above->above & ~below->above & bit) != 0) {
      start_edge(cursor, *below, *above);
      return;
    }
    a = b;
  }
}

// Where more than two edges cross, the outermost count.
Interval ragged_interval(const Scene& scene, const BandRow& row, const Direction* directions,
                         const FaceView& view) {
  int32_t left = kRowEnd, right = 0;
  bool left_behind = false, right_behind = false;
  const Direction* a = directions + view_corner(scene, view, view.corner_count - 1);
  for (int k = 0; k < view.corner_count; ++k) {
    const Direction* b = directions + view_corner(scene, view, k);
    if (((a->above ^ b->above) & row.bit) != 0) {
      const bool upwards = (b->above & row.bit) != 0;
      const bool is_left = upwards != view.is_back;
      EdgeCursor edge;
      start_edge(edge, upwards ? *a : *b, upwards ? *b : *a);
      if (is_behind(edge)) {
        (is_left ? left_behind : right_behind) = true;
      } else {
        const int32_t x = crossing(edge, row.plane);
        left = is_left && x < left ? x : left;
        right = !is_left && x > right ? x : right;
      }
    }
    a = b;
  }
  if (left_behind && right_behind) {
    return {0, 0};
  }
  return {left_behind ? 0 : left, right_behind ? kRowEnd : right};
}

}  // namespace

void turn_view(int side, uint16_t vertex_count, Workspace& work) {
  for (uint16_t i = 0; i < vertex_count; ++i) {
    turn_to(side, work.directions[i].x, work.directions[i].y, work.directions[i].z);
  }
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    turn_to(side, view.depth[0], view.depth[1], view.depth[2]);
    turn_to(side, view.grid_u);
    turn_to(side, view.grid_v);
    turn_to(side, view.grid_n);
  }
}

void enter_band(const Scene& scene, const DeltaTable& table, int first, int count, Workspace& work) {
  find_rows_below(table, first, count, scene.vertex_count, work.directions);
  for (uint16_t i = 0; i < work.view_count; ++i) {
    find_rows(scene, count, work.directions, work.views[i]);
  }
}

void enter_side_band(const Scene& scene, const DeltaTable& table, int side, int first, int count,
                     Workspace& work) {
  enter_band(scene, table, first, count, work);
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    if (view.rows != 0 && is_outside(scene, side, work.directions, view)) {
      view.rows = 0;
    }
  }
}

// Seen from the eye with z away from it, a front face runs clockwise in (x, y): its rising edges are on the
// left. An end behind the eye leaves the row at its own border.
Interval face_interval(const Scene& scene, const BandRow& row, const Direction* directions, FaceView& view) {
  if ((view.ragged & row.bit) != 0) {
    return ragged_interval(scene, row, directions, view);
  }
  if ((view.left.rows & row.bit) == 0) {
    find_edge(scene, row.bit, !view.is_back, directions, view, view.left);
  }
  if ((view.right.rows & row.bit) == 0) {
    find_edge(scene, row.bit, view.is_back, directions, view, view.right);
  }
  const bool left_behind = is_behind(view.left), right_behind = is_behind(view.right);
  if (left_behind && right_behind) {
    return {0, 0};
  }
  return {left_behind ? 0 : crossing(view.left, row.plane),
          right_behind ? kRowEnd : crossing(view.right, row.plane)};
}

}  // namespace fixrad

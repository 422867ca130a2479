// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_scanline.h"

#include <algorithm>
#include <cmath>

#include "lib/form_factor/scanline.h"

namespace fixrad::host {
namespace {

glm::dvec3 into_side(const glm::dvec3& v, int side) {
  switch (side) {
    case kTop:
      return v;
    case 1:
      return {v.y, v.z, v.x};
    case 2:
      return {-v.x, v.z, v.y};
    case 3:
      return {-v.y, v.z, -v.x};
    default:
      return {v.x, v.z, -v.y};
  }
}

glm::dvec3 out_of_side(const glm::dvec3& v, int side) {
  switch (side) {
    case kTop:
      return v;
    case 1:
      return {v.z, v.x, v.y};
    case 2:
      return {-v.x, v.z, v.y};
    case 3:
      return {-v.z, -v.x, v.y};
    default:
      return {v.x, -v.z, v.y};
  }
}

// Half-spaces through the eye that a hemicube side lies outside of.
int outcode(const glm::dvec3& v, int side) {
  int code = v.z <= 0 ? 1 : 0;
  code |= v.x > v.z ? 2 : 0;
  code |= v.x < -v.z ? 4 : 0;
  code |= v.y > v.z ? 8 : 0;
  code |= (side == kTop ? v.y < -v.z : v.y <= 0) ? 16 : 0;
  return code;
}

// Wider by a hair than what the corners say: the crossing test of each row decides, and its rounding must not
// be cut off here.
void find_rows(const TwinScene& scene, int side, int resolution, const TwinView& view, TwinFaceView& seen) {
  constexpr double kSlack = 1e-9;
  const TwinFace& face = scene.faces[seen.face];
  double lowest = 1, highest = -1;
  int outside = 31;
  bool is_in_front = true;
  for (std::uint32_t k = 0; k < face.corner_count; ++k) {
    const glm::dvec3& v = view.side_directions[scene.corners[face.first_corner + k]];
    outside &= outcode(v, side);
    is_in_front = is_in_front && v.z > 0;
    if (is_in_front) {
      const double height = v.y / v.z;
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
  }
  const int bottom = side == kTop ? 0 : resolution / 2;
  seen.first_row = bottom;
  seen.last_row = outside == 0 ? resolution - 1 : -1;
  if (is_in_front && outside == 0) {
    const auto row_below = [&](double height) {
      return static_cast<int>(std::floor((std::clamp(height, -2.0, 2.0) * resolution + resolution - 1) / 2));
    };
    seen.first_row = std::max(bottom, row_below(lowest - kSlack) + 1);
    seen.last_row = std::min(resolution - 1, row_below(highest + kSlack));
  }
}

void start_edge(TwinEdgeCursor& cursor, int edge, const glm::dvec3& below, const glm::dvec3& above) {
  const glm::dvec3 e = glm::cross(below, above);
  cursor = {e.z, e.y, -e.x, edge};
}

// x where an edge in front of the eye (reach > 0) crosses the row.
double crossing(const TwinEdgeCursor& cursor, double y) {
  const double offset = cursor.base + y * cursor.step;
  if (offset <= -cursor.reach) {
    return -1;
  }
  return offset >= cursor.reach ? 1 : offset / cursor.reach;
}

}  // namespace

TwinRow twin_row(int side, int r, int resolution) {
  const double y = static_cast<double>(2 * r + 1 - resolution) / resolution;
  return {out_of_side({1, 0, 0}, side), out_of_side({0, y, 1}, side), y};
}

void enter_twin_side(const TwinScene& scene, int side, int resolution, TwinView& view) {
  for (std::size_t i = 0; i < view.directions.size(); ++i) {
    view.side_directions[i] = into_side(view.directions[i], side);
  }
  for (std::size_t i = 0; i < view.count; ++i) {
    view.faces[i].left.edge = kNoTwinEdge;
    view.faces[i].right.edge = kNoTwinEdge;
    find_rows(scene, side, resolution, view, view.faces[i]);
  }
}

// Seen from the eye with z away from it, a front face runs clockwise in (x, y): its rising edges are on the
// left. An end behind the eye leaves the row at its own border.
TwinInterval twin_face_interval(const TwinScene& scene, double y, const TwinView& view, TwinFaceView& seen) {
  const TwinFace& face = scene.faces[seen.face];
  const std::uint16_t* corners = scene.corners.data() + face.first_corner;
  TwinInterval part = {1, -1};
  bool left_behind = false, right_behind = false;
  const int count = static_cast<int>(face.corner_count);
  int from = count - 1;
  const glm::dvec3* a = &view.side_directions[corners[from]];
  bool a_above = a->y >= y * a->z;
  for (int k = 0; k < count; from = k++) {
    const glm::dvec3* b = &view.side_directions[corners[k]];
    const bool b_above = b->y >= y * b->z;
    if (a_above != b_above) {
      const bool is_left = b_above != seen.is_back;
      TwinEdgeCursor& cursor = is_left ? seen.left : seen.right;
      if (cursor.edge != from) {
        start_edge(cursor, from, b_above ? *a : *b, b_above ? *b : *a);
      }
      if (cursor.reach <= 0) {
        (is_left ? left_behind : right_behind) = true;
      } else if (is_left) {
        part.begin = std::min(part.begin, crossing(cursor, y));
      } else {
        part.end = std::max(part.end, crossing(cursor, y));
      }
    }
    a = b;
    a_above = b_above;
  }
  if (left_behind && right_behind) {
    return {0, 0};
  }
  return {left_behind ? -1 : part.begin, right_behind ? 1 : part.end};
}

}  // namespace fixrad::host

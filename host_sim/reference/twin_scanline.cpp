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

bool is_outside(const TwinScene& scene, int side, const TwinView& view, const TwinFaceView& seen) {
  const TwinFace& face = scene.faces[seen.face];
  int outside = 31;
  for (std::uint32_t k = 0; k < face.corner_count; ++k) {
    outside &= outcode(view.side_directions[scene.corners[face.first_corner + k]], side);
  }
  return outside != 0;
}

// Rows from `bottom` up that the corners of a face lie between, by their heights y / z (hemicube) or y / |(y,
// z)| (lunes). Wider by a hair: the crossing test of each row decides, and its rounding must not be cut off
// here.
void find_rows(const TwinScene& scene, bool is_lune, int bottom, int resolution, const TwinView& view,
               TwinFaceView& seen) {
  constexpr double kSlack = 1e-9;
  const TwinFace& face = scene.faces[seen.face];
  double lowest = 1, highest = -1;
  seen.first_row = bottom;
  seen.last_row = resolution - 1;
  for (std::uint32_t k = 0; k < face.corner_count; ++k) {
    const glm::dvec3& v = view.side_directions[scene.corners[face.first_corner + k]];
    if (v.z <= 0) {
      return;
    }
    const double height = v.y / (is_lune ? std::hypot(v.y, v.z) : v.z);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  const auto row_below = [resolution](double height) {
    return static_cast<int>(std::floor((std::clamp(height, -2.0, 2.0) * resolution + resolution - 1) / 2));
  };
  seen.first_row = std::max(bottom, row_below(lowest - kSlack) + 1);
  seen.last_row = std::min(resolution - 1, row_below(highest + kSlack));
}

void forget_edges(TwinFaceView& seen) {
  seen.left.edge = seen.right.edge = kNoTwinEdge;
}

double middle_of_row(int r, int resolution) {
  return static_cast<double>(2 * r + 1 - resolution) / resolution;
}

}  // namespace

TwinRow twin_row(int side, int r, int resolution) {
  const double y = middle_of_row(r, resolution);
  return {out_of_side({1, 0, 0}, side), out_of_side({0, y, 1}, side), y, 1, false};
}

TwinRow twin_lune(int r, int resolution) {
  const double sine = middle_of_row(r, resolution);
  const double cosine = std::sqrt(1 - sine * sine);
  return {{1, 0, 0}, {0, sine, cosine}, sine, cosine, true};
}

void enter_twin_side(const TwinScene& scene, int side, int resolution, TwinView& view) {
  for (std::size_t i = 0; i < view.directions.size(); ++i) {
    view.side_directions[i] = into_side(view.directions[i], side);
  }
  for (std::size_t i = 0; i < view.count; ++i) {
    TwinFaceView& seen = view.faces[i];
    forget_edges(seen);
    find_rows(scene, false, side == kTop ? 0 : resolution / 2, resolution, view, seen);
    seen.last_row = is_outside(scene, side, view, seen) ? -1 : seen.last_row;
  }
}

void enter_twin_lunes(const TwinScene& scene, int resolution, TwinView& view) {
  view.side_directions = view.directions;
  for (std::size_t i = 0; i < view.count; ++i) {
    forget_edges(view.faces[i]);
    find_rows(scene, true, 0, resolution, view, view.faces[i]);
  }
}

// Seen from the eye with z away from it, a front face runs clockwise in (x, y): its rising edges are on the
// left. An end behind the eye leaves the row at its own border.
TwinInterval twin_face_interval(const TwinScene& scene, const TwinRow& row, const TwinView& view,
                                TwinFaceView& seen) {
  const TwinFace& face = scene.faces[seen.face];
  const std::uint16_t* corners = scene.corners.data() + face.first_corner;
  TwinInterval part = {1, -1};
  bool left_behind = false, right_behind = false;
  const int count = static_cast<int>(face.corner_count);
  int from = count - 1;
  const glm::dvec3* a = &view.side_directions[corners[from]];
  bool a_above = a->y * row.z >= row.y * a->z;
  for (int k = 0; k < count; from = k++) {
    const glm::dvec3* b = &view.side_directions[corners[k]];
    const bool b_above = b->y * row.z >= row.y * b->z;
    if (a_above != b_above) {
      const bool is_left = b_above != seen.is_back;
      TwinEdgeCursor& cursor = is_left ? seen.left : seen.right;
      if (cursor.edge != from) {
        cursor = {b_above ? glm::cross(*a, *b) : glm::cross(*b, *a), from};
      }
      const glm::dvec3& normal = cursor.normal;
      const double x = row.crossing(normal.x, normal.y * row.y + normal.z * row.z);
      if (normal.x >= 0) {
        (is_left ? left_behind : right_behind) = true;
      } else if (is_left) {
        part.begin = std::min(part.begin, x);
      } else {
        part.end = std::max(part.end, x);
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

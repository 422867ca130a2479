// SPDX-License-Identifier: MIT
#include "host_sim/report/automatic_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <vector>

namespace fixrad::host {
namespace {

/// Part of the picture that the mesh fills, along the tighter direction.
constexpr double kFill = 0.95;
/// A room's walls enclose at least this part of its box, by the divergence theorem. Five of six walls give
/// 0.83, a floor with two walls 0.5, an object less than 0.
constexpr double kRoomShare = 0.6;
/// A side of the box is covered by faces within this part of the extent from it; half covered counts as
/// closed.
constexpr double kSideDepth = 0.05;
constexpr double kClosedCover = 0.5;
/// Covers that differ by less than this are the same.
constexpr double kCoverTolerance = 0.02;
/// Three-quarter view: degrees from the axes, and above the horizon.
constexpr double kAzimuth = 35.0;
constexpr double kElevation = 25.0;

struct Facet {
  glm::dvec3 centroid;
  glm::dvec3 area;  ///< area times unit normal
};

struct Shape {
  glm::dvec3 low{std::numeric_limits<double>::max()};
  glm::dvec3 high{std::numeric_limits<double>::lowest()};
  std::vector<Facet> facets;

  glm::dvec3 centre() const { return 0.5 * (low + high); }
  glm::dvec3 extent() const { return high - low; }
};

Shape shape_of(const BakedMesh& mesh) {
  Shape shape;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<glm::dvec3, 3> p = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    for (const glm::dvec3& corner : p) {
      for (int k = 0; k < 3; ++k) {
        shape.low[k] = std::min(shape.low[k], corner[k]);
        shape.high[k] = std::max(shape.high[k], corner[k]);
      }
    }
    shape.facets.push_back({(p[0] + p[1] + p[2]) / 3.0, 0.5 * glm::cross(p[1] - p[0], p[2] - p[0])});
  }
  return shape;
}

/// Part of the box that inward-looking faces enclose: 1 for the box itself turned inside out, negative for
/// objects.
double enclosed_share(const Shape& shape) {
  const glm::dvec3 extent = shape.extent();
  const double volume = extent.x * extent.y * extent.z;
  double outward = 0.0;
  for (const Facet& facet : shape.facets) {
    outward += glm::dot(facet.area, facet.centroid - shape.centre());
  }
  return volume > 0.0 ? -outward / (3.0 * volume) : 0.0;
}

/// Part of one side of the box (axis 0..2, the high side or the low one) covered by faces that look inwards.
double cover(const Shape& shape, int axis, bool high_side) {
  const glm::dvec3 extent = shape.extent();
  const double sign = high_side ? 1.0 : -1.0;
  const double side = high_side ? shape.high[axis] : shape.low[axis];
  double covered = 0.0;
  for (const Facet& facet : shape.facets) {
    if (std::abs(facet.centroid[axis] - side) <= kSideDepth * extent[axis]) {
      covered += std::max(0.0, -sign * facet.area[axis]);
    }
  }
  return covered / (extent[(axis + 1) % 3] * extent[(axis + 2) % 3]);
}

/// The horizontal direction into a room through its most open side; among equals the widest side, then the
/// order of a modelling tool's front views.
glm::dvec3 view_into_room(const Shape& shape, bool z_up) {
  const int depth = z_up ? 1 : 2;
  struct Side {
    int axis;
    bool high;
  };
  const std::array<Side, 4> sides = {{{depth, !z_up}, {depth, z_up}, {0, true}, {0, false}}};
  Side best = sides[0];
  double best_cover = std::numeric_limits<double>::max();
  double best_width = 0.0;
  for (const Side& side : sides) {
    const double side_cover = cover(shape, side.axis, side.high);
    const double width = shape.extent()[side.axis == 0 ? depth : 0];
    const bool as_open = side_cover < best_cover + kCoverTolerance;
    if (side_cover < best_cover - kCoverTolerance ||
        (as_open && width > best_width * (1.0 + kCoverTolerance))) {
      best = side;
      best_cover = side_cover;
      best_width = width;
    }
  }
  glm::dvec3 forward(0.0);
  forward[best.axis] = best.high ? -1.0 : 1.0;
  return forward;
}

/// The direction from the mesh to the eye, for an azimuth from the front view's side towards +x.
glm::dvec3 direction_to_eye(double azimuth_degrees, double elevation_degrees, bool z_up) {
  const double azimuth = glm::radians(azimuth_degrees);
  const double elevation = glm::radians(elevation_degrees);
  const double x = std::sin(azimuth) * std::cos(elevation);
  const double front = std::cos(azimuth) * std::cos(elevation);
  const double up = std::sin(elevation);
  return z_up ? glm::dvec3(x, -front, up) : glm::dvec3(x, up, front);
}

glm::dvec3 three_quarter_view(const Shape& shape, bool z_up) {
  glm::dvec3 best(0.0);
  double best_area = -1.0;
  for (const double elevation : {kElevation, -kElevation}) {
    for (const double azimuth : {kAzimuth, -kAzimuth, 180.0 - kAzimuth, 180.0 + kAzimuth}) {
      const glm::dvec3 to_eye = direction_to_eye(azimuth, elevation, z_up);
      double area = 0.0;
      for (const Facet& facet : shape.facets) {
        area += std::max(0.0, glm::dot(facet.area, to_eye));
      }
      if (area > best_area * (1.0 + kCoverTolerance)) {
        best_area = area;
        best = -to_eye;
      }
    }
  }
  return best;
}

/// The nearest eye that sees every vertex when it looks along `forward`: each plane of the frustum touches
/// the vertex that is farthest out on its side.
Camera fit(const BakedMesh& mesh, const Shape& shape, const glm::dvec3& forward, bool z_up, double aspect) {
  Camera camera;
  const ViewAxes axes = view_axes(forward, z_up);
  const double tangent_y = kFill * std::tan(glm::radians(camera.vertical_fov) / 2.0);
  const double tangent_x = tangent_y * aspect;
  double right = std::numeric_limits<double>::lowest();
  double left = right;
  double top = right;
  double bottom = right;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      const glm::dvec3 d = mesh.positions[corner] - shape.centre();
      const double x = glm::dot(d, axes.right);
      const double y = glm::dot(d, axes.up);
      const double z = glm::dot(d, forward);
      right = std::max(right, x - z * tangent_x);
      left = std::max(left, -x - z * tangent_x);
      top = std::max(top, y - z * tangent_y);
      bottom = std::max(bottom, -y - z * tangent_y);
    }
  }
  const double distance = std::max((right + left) / (2.0 * tangent_x), (top + bottom) / (2.0 * tangent_y));
  const glm::dvec3 shift = 0.5 * (right - left) * axes.right + 0.5 * (top - bottom) * axes.up;
  camera.target = shape.centre() + shift;
  camera.eye = camera.target - (distance > 0.0 ? distance : 1.0) * forward;
  return camera;
}

}  // namespace

Camera automatic_camera(const BakedMesh& mesh, bool z_up, double aspect) {
  const Shape shape = shape_of(mesh);
  const bool room = enclosed_share(shape) > kRoomShare;
  const bool ceiling = room && cover(shape, z_up ? 2 : 1, true) > kClosedCover;
  const glm::dvec3 forward = ceiling ? view_into_room(shape, z_up) : three_quarter_view(shape, z_up);
  return fit(mesh, shape, forward, z_up, aspect);
}

}  // namespace fixrad::host

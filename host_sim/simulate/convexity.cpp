// SPDX-License-Identifier: MIT
#include "host_sim/simulate/convexity.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace fixrad::host {
namespace {

// A face in grid units; the numbers are whole and small, so doubles hold them exactly.
struct Polygon {
  std::vector<glm::dvec3> corners;
  glm::dvec3 normal;  // of length kUnit
};

std::vector<Polygon> polygons_of(const DeviceScene& device) {
  std::vector<Polygon> polygons;
  for (const fixrad::Face& face : device.faces) {
    Polygon polygon = {{}, {face.normal[0], face.normal[1], face.normal[2]}};
    for (std::size_t k = 0; k < face.corner_count; ++k) {
      const Vertex& v = device.vertices[device.corners[face.first_corner + k]];
      polygon.corners.emplace_back(v.x, v.y, v.z);
    }
    polygons.push_back(polygon);
  }
  return polygons;
}

constexpr double kHeightTolerance = double{kPlaneTolerance} * kUnit;

double height_over(const Polygon& polygon, const glm::dvec3& point) {
  return glm::dot(polygon.normal, point - polygon.corners[0]);
}

bool is_before(const Polygon& polygon, const Polygon& other) {
  return std::all_of(other.corners.begin(), other.corners.end(), [&](const glm::dvec3& corner) {
    return height_over(polygon, corner) >= -kHeightTolerance;
  });
}

bool is_in_plane(const Polygon& polygon, const Polygon& other) {
  return is_before(polygon, other) &&
         std::all_of(other.corners.begin(), other.corners.end(), [&](const glm::dvec3& corner) {
           return height_over(polygon, corner) <= kHeightTolerance;
         });
}

// Has `polygon` an edge with all of `other` on its far side, but for kPlaneTolerance?
bool has_edge_between(const Polygon& polygon, const Polygon& other) {
  for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
    const glm::dvec3& a = polygon.corners[k];
    const glm::dvec3 along = polygon.corners[(k + 1) % polygon.corners.size()] - a;
    const double slack = kHeightTolerance * glm::length(along);
    if (std::all_of(other.corners.begin(), other.corners.end(), [&](const glm::dvec3& corner) {
          return glm::dot(glm::cross(along, corner - a), polygon.normal) <= slack;
        })) {
      return true;
    }
  }
  return false;
}

// Two layers in one plane, the upper of which hides the lower.
bool are_layers(const Polygon& a, const Polygon& b) {
  return glm::dot(a.normal, b.normal) > 0 && is_in_plane(a, b) && !has_edge_between(a, b) &&
         !has_edge_between(b, a);
}

}  // namespace

bool is_convex(const DeviceScene& device) {
  const std::vector<Polygon> polygons = polygons_of(device);
  for (const Polygon& a : polygons) {
    for (const Polygon& b : polygons) {
      if (&a != &b && (!is_before(a, b) || are_layers(a, b))) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace fixrad::host

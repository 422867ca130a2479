// SPDX-License-Identifier: MIT
#include "host_sim/meshing/gather_points.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

// Grid units into the element. Nearer to a wall than a thousandth of the scene, the rounded directions to its
// corners bend it; four times as far, the steep rise of light in a corner is missed.
constexpr double kInset = 24;
constexpr double kHalfWay = 0.5;
constexpr std::size_t kMostPoints = 16;  // as many as there are turns

constexpr std::size_t kEnough = 2;
constexpr double kFlat = 0.9998;  // cosine of about one degree

constexpr double kLeastLift = 2;  // quarters of a grid unit, as an element's eye has
constexpr double kMostLift = 40;

glm::dvec3 direction(const std::int16_t (&a)[3]) {
  return glm::dvec3(a[0], a[1], a[2]) / static_cast<double>(kUnit);
}

}  // namespace

GatherPoint gather_point(const DeviceScene& device, std::uint16_t element, glm::dvec3 position) {
  const fixrad::Face& face = device.faces[device.elements[element].face];
  const Vertex corner = device.vertices[device.corners[face.first_corner]];
  const glm::dvec3 plane_point = glm::dvec3(corner.x, corner.y, corner.z) * static_cast<double>(kEyeScale);
  const glm::dvec3 normal = direction(face.normal);
  const auto to_grid = [&](glm::dvec3 p) { return (p - device.grid.origin) * device.grid.scale; };
  const glm::dvec3 at = to_grid(position), centroid = to_grid(device.mesh.elements[element].centroid);
  const double part = std::min(kHalfWay, kInset / std::max(kInset, glm::distance(at, centroid)));
  const glm::dvec3 inside = glm::mix(at, centroid, part) * static_cast<double>(kEyeScale);
  glm::dvec3 lifted(0.0);
  for (double lift = kLeastLift; lift < kMostLift; lift += 1) {
    lifted = glm::round(inside + lift * normal);
    if (glm::dot(lifted - plane_point, normal) >= 1) {
      break;
    }
  }
  GatherPoint point = {{0, 0, 0}, element};
  for (int k = 0; k < 3; ++k) {
    point.position[k] = static_cast<std::uint16_t>(std::clamp(lifted[k], 0.0, 65535.0));
  }
  return point;
}

VertexGather vertex_gather(const DeviceScene& device, glm::dvec3 position,
                           const std::vector<std::uint16_t>& elements) {
  const std::size_t count = std::min(elements.size(), kMostPoints);
  const glm::dvec3 normal = device.mesh.elements[elements.front()].normal;
  bool is_flat = true;
  VertexGather gather;
  // Every other element first: two that are opposite rather than neighbours.
  for (const std::size_t start : {std::size_t{0}, std::size_t{1}}) {
    for (std::size_t i = start; i < count; i += 2) {
      const std::uint16_t e = elements[i * elements.size() / count];
      gather.points.push_back(gather_point(device, e, position));
      is_flat = is_flat && glm::dot(device.mesh.elements[e].normal, normal) > kFlat;
    }
  }
  if (count == 1) {
    gather.points.push_back(gather.points.front());
  }
  gather.enough = static_cast<std::uint8_t>(is_flat ? kEnough : gather.points.size());
  return gather;
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/simulate/eye_sights.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "host_sim/meshing/segment_part.h"
#include "host_sim/simulate/simulated_device.h"

namespace fixrad::host {
namespace {

// Grid units. Corners are off their plane by kPlaneTolerance, eyes are lifted by half a unit or a little
// more.
constexpr double kContact = kPlaneTolerance + 1;

struct Box2d {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};

  void add(glm::dvec2 p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  // Neighbours that only share a border with an element do not reach into it.
  bool reaches_into(const Box2d& other) const {
    return low.x < other.high.x - kContact && high.x > other.low.x + kContact &&
           low.y < other.high.y - kContact && high.y > other.low.y + kContact;
  }
};

// A face's plane with two axes in it; lengths in grid units.
struct Plane {
  glm::dvec3 point, normal, u, v;

  double height(glm::dvec3 p) const { return glm::dot(p - point, normal); }
  glm::dvec2 flat(glm::dvec3 p) const { return {glm::dot(p - point, u), glm::dot(p - point, v)}; }
};

glm::dvec3 unit(const std::int16_t (&a)[3]) {
  return glm::normalize(glm::dvec3(a[0], a[1], a[2]));
}

glm::dvec3 corner(const DeviceScene& device, const fixrad::Face& face, std::size_t k) {
  const Vertex v = device.vertices[device.corners[face.first_corner + k % face.corner_count]];
  return {v.x, v.y, v.z};
}

Plane plane_of(const DeviceScene& device, const fixrad::Face& face) {
  const glm::dvec3 normal = unit(face.normal);
  const glm::dvec3 u = unit(face.tangent);
  return {corner(device, face, 0), normal, u, glm::cross(normal, u)};
}

// The part of `face` within kContact of the plane, as a box in the plane; empty if there is none.
Box2d contact_of(const DeviceScene& device, const Plane& plane, const fixrad::Face& face) {
  Box2d box;
  for (std::size_t k = 0; k < face.corner_count; ++k) {
    const glm::dvec3 a = corner(device, face, k), b = corner(device, face, k + 1);
    const double from = plane.height(a), to = plane.height(b);
    SegmentPart near;
    near.keep_where(kContact - from, kContact - to);
    near.keep_where(kContact + from, kContact + to);
    if (near.begin <= near.end) {
      box.add(plane.flat(glm::mix(a, b, near.begin)));
      box.add(plane.flat(glm::mix(a, b, near.end)));
    }
  }
  return box;
}

Box2d outline_of(const DeviceScene& device, std::size_t element, const Plane& plane) {
  Box2d box;
  for (const glm::dvec3& p : device.mesh.elements[element].polygon) {
    box.add(plane.flat((p - device.grid.origin) * device.grid.scale));
  }
  return box;
}

Sight sight_of(State& state, const Element& element, bool is_met) {
  std::uint32_t share = 0;
  const EyePoint eye = {vec(element.eye), element.face, 0};
  if (hidden_share(state.scene, kLunes[0], eye, state.is_enclosed, state.work, share) != Status::ok) {
    return Sight::unknown;
  }
  if (share > kBuriedShare) {
    return Sight::centroid_buried;
  }
  return is_met || share > 0 ? Sight::centroid_clear : Sight::all_clear;
}

}  // namespace

void find_sights(DeviceScene& device, const Sizes& sizes) {
  device.sights.clear();
  SimulatedDevice probe(sizes);
  if (probe.load(device.view(), Settings{}) != Status::ok) {
    return;  // the solver will say why
  }
  for (std::size_t e = 0; e < device.elements.size();) {
    const std::uint16_t f = device.elements[e].face;
    const Plane plane = plane_of(device, device.faces[f]);
    std::vector<Box2d> contacts;
    for (std::size_t g = 0; g < device.faces.size(); ++g) {
      const Box2d box = g == f ? Box2d{} : contact_of(device, plane, device.faces[g]);
      if (box.low.x <= box.high.x) {
        contacts.push_back(box);
      }
    }
    for (; e < device.elements.size() && device.elements[e].face == f; ++e) {
      const Box2d outline = outline_of(device, e, plane);
      const bool is_met = std::any_of(contacts.begin(), contacts.end(),
                                      [&](const Box2d& box) { return box.reaches_into(outline); });
      device.sights.push_back(sight_of(probe.state(), device.elements[e], is_met));
    }
  }
}

}  // namespace fixrad::host

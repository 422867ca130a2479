// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// The mesh that is displayed: corners of the elements, shared within a smooth surface and nowhere else.
/// `map` is what the core averages by; it points into this object, which must not move while it is used.
struct SurfaceMesh {
  std::vector<glm::dvec3> positions;  ///< scene unit
  std::vector<glm::dvec3> normals;    ///< unit
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint16_t> triangle_elements;  ///< [triangles] the element that each is a part of
  std::vector<MeshVertex> vertices;              ///< [positions]
  std::vector<std::uint16_t> elements;           ///< pointed into by vertices

  VertexMap map() const {
    return {vertices.data(), elements.data(), static_cast<std::uint32_t>(vertices.size())};
  }
};

/// Number of the smooth surface of each convex face: neighbours of one material belong to one surface if they
/// are coplanar, or share a smoothing group and meet at less than 60 degrees.
std::vector<std::uint32_t> smooth_surfaces(const PreparedScene& scene);

SurfaceMesh make_surface_mesh(const PreparedScene& scene, const DeviceScene& device);

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_scene.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

// Newell's normal: the mean plane of a polygon whose corners have been rounded.
glm::dvec3 polygon_normal(const TwinScene& twin, const TwinFace& face) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 first = twin.vertices[twin.corners[face.first_corner]];
  for (std::uint32_t k = 1; k + 1 < face.corner_count; ++k) {
    const glm::dvec3 a = twin.vertices[twin.corners[face.first_corner + k]] - first;
    const glm::dvec3 b = twin.vertices[twin.corners[face.first_corner + k + 1]] - first;
    sum += glm::cross(a, b);
  }
  return glm::normalize(sum);
}

TwinFace make_face(const TwinScene& twin, const Face& record) {
  TwinFace face = {};
  face.first_corner = record.first_corner;
  face.is_sealed = record.is_sealed != 0;
  face.corner_count = record.corner_count;
  face.first_cell_row = record.first_cell_row;
  face.cells_u = record.cells_u;
  face.cells_v = record.cells_v;
  face.origin = to_double(vec(record.origin)) * static_cast<double>(kEyeScale);
  face.axis_u = to_double(vec(record.axis_u)) * static_cast<double>(kEyeScale);
  face.axis_v = to_double(vec(record.axis_v)) * static_cast<double>(kEyeScale);
  face.normal = polygon_normal(twin, face);
  const glm::dvec3 tangent = to_double(vec(record.tangent));
  face.tangent = glm::normalize(tangent - glm::dot(tangent, face.normal) * face.normal);
  return face;
}

void add_element(TwinScene& twin, const Scene& scene, const Element& element) {
  const Material material = flash_read(scene.materials, flash_read(scene.faces, element.face).material);
  twin.element_area.push_back(element.area);
  for (int c = 0; c < scene.channels; ++c) {
    const double density = std::ldexp(static_cast<double>(material.emission[c]), -scene.emission_shift);
    twin.emitted.push_back(density * element.area);
    twin.reflectance.push_back(
        std::ldexp(static_cast<double>(material.reflectance[c]), -Reflectance::frac_bits));
  }
}

}  // namespace

TwinScene make_twin_scene(const Scene& scene) {
  TwinScene twin;
  twin.channels = scene.channels;
  for (unsigned i = 0; i < scene.vertex_count; ++i) {
    twin.vertices.push_back(to_double(vec(flash_read(scene.vertices, i))) * static_cast<double>(kEyeScale));
  }
  for (unsigned i = 0; i < scene.corner_count; ++i) {
    twin.corners.push_back(flash_read(scene.corners, i));
  }
  for (unsigned i = 0; i < scene.face_count; ++i) {
    twin.faces.push_back(make_face(twin, flash_read(scene.faces, i)));
  }
  for (unsigned i = 0; i < scene.cell_row_count; ++i) {
    twin.cell_rows.push_back(flash_read(scene.cell_rows, i));
  }
  for (unsigned i = 0; i < scene.root_count; ++i) {
    twin.roots.push_back(flash_read(scene.roots, i));
  }
  for (unsigned i = 0; i < scene.cut_count; ++i) {
    twin.cuts.push_back(flash_read(scene.cuts, i));
  }
  for (unsigned i = 0; i < scene.element_count; ++i) {
    add_element(twin, scene, flash_read(scene.elements, i));
  }
  return twin;
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/reference/input_polygons.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

/// Corners this part of the polygon's size off its plane make it triangles: well under the lift of a ray.
constexpr double kPlanar = 1e-9;

using Corners = std::vector<glm::dvec3>;

glm::dvec3 doubled_area(const Corners& corners) {
  glm::dvec3 sum{0.0};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    sum += glm::cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
  }
  return sum;
}

bool is_planar(const Corners& corners) {
  const glm::dvec3 normal = doubled_area(corners);
  return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
    return std::abs(glm::dot(corner - corners[0], normal)) <=
           kPlanar * glm::length(normal) * std::sqrt(glm::length(normal));
  });
}

glm::dvec3 centroid_of(const Corners& corners) {
  const glm::dvec3 whole = doubled_area(corners);
  glm::dvec3 sum{0.0};
  double weights = 0.0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const double weight = glm::dot(glm::cross(corners[k] - corners[0], corners[k + 1] - corners[0]), whole);
    sum += weight * (corners[0] + corners[k] + corners[k + 1]) / 3.0;
    weights += weight;
  }
  return sum / weights;
}

/// Adds polygons of one input face.
class PolygonList {
 public:
  PolygonList(const Model& model, std::vector<MeshElement>& polygons) : model_(model), polygons_(polygons) {}

  void add(const Corners& corners, std::uint32_t face) {
    if (is_planar(corners)) {
      append(corners, face);
      return;
    }
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      append({corners[0], corners[k], corners[k + 1]}, face);
    }
  }

 private:
  void append(const Corners& corners, std::uint32_t face) {
    const glm::dvec3 doubled = doubled_area(corners);
    if (!(glm::length(doubled) > 0.0)) {
      return;
    }
    const Material& material = model_.materials[model_.faces[face].material];
    MeshElement polygon;
    polygon.polygon = corners;
    polygon.centroid = centroid_of(corners);
    polygon.normal = glm::normalize(doubled);
    polygon.area = 0.5 * glm::length(doubled);
    polygon.reflectance = material.reflectance;
    polygon.emission = material.emission;
    polygon.input_face = face;
    polygons_.push_back(polygon);
  }

  const Model& model_;
  std::vector<MeshElement>& polygons_;
};

/// Where a face's file has the corner that was welded to this grid point.
glm::dvec3 original_position(const PreparedScene& scene, const Face& face, std::uint32_t welded) {
  const auto corner = std::find_if(face.corners.begin(), face.corners.end(),
                                   [&](std::uint32_t v) { return scene.vertices.index_of[v] == welded; });
  return scene.model->positions[*corner];
}

}  // namespace

std::vector<MeshElement> input_polygons(const PreparedScene& scene) {
  const Model& model = *scene.model;
  std::vector<MeshElement> polygons;
  std::vector<bool> has_piece(model.faces.size(), false);
  PolygonList list(model, polygons);
  for (const ConvexFace& convex : scene.faces) {
    for (const FacePart& part : convex.parts) {
      const Face& face = model.faces[part.input_face];
      Corners corners;
      for (const std::uint32_t welded : part.corners) {
        corners.push_back(original_position(scene, face, welded));
      }
      list.add(corners, part.input_face);
      has_piece[part.input_face] = true;
    }
  }
  for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
    if (!has_piece[f]) {
      Corners corners;
      for (const std::uint32_t v : model.faces[f].corners) {
        corners.push_back(model.positions[v]);
      }
      list.add(corners, f);
    }
  }
  return polygons;
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "tests/meshing/shading_error.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/meshing/direct_light.h"
#include "host_sim/meshing/element_light.h"
#include "host_sim/meshing/surface_mesh.h"

namespace fixrad::host {
namespace {

constexpr double kPoints = 5000;
constexpr std::uint32_t kOfElement = 48;  // points for an element's mean
constexpr double kLift = 0.25;            // grid units
constexpr double kInwards = 3.0;          // grid units from a vertex into the triangles that share it

/// The displayed triangles of a scene with the light at their corners.
class Shading {
 public:
  Shading(const PreparedScene& scene, const DirectLight& light, const Meshing& meshing)
      : scene_(scene), device_(make_device_scene(scene, meshing)), mesh_(make_surface_mesh(scene, device_)) {
    std::vector<double> count(mesh_.positions.size(), 0.0);
    light_.resize(mesh_.positions.size(), 0.0);
    of_face_.resize(scene.faces.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const glm::dvec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
      const std::uint32_t face = face_of(glm::normalize(glm::cross(b - a, c - a)), (a + b + c) / 3.0);
      of_face_[face].push_back(t);
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 way = (a + b + c) / 3.0 - corner(t, k);
        const FaceFrame& frame = scene.frames[face];
        glm::dvec3 at = corner(t, k) + way * std::min(1.0, kInwards / glm::length(way));
        at += frame.normal * (kLift - glm::dot(frame.normal, at - frame.height));
        if (!light.is_buried(face, at)) {
          light_[mesh_.triangles[t][k]] += light.irradiance(face, at);
          count[mesh_.triangles[t][k]] += 1;
        }
      }
    }
    for (std::size_t v = 0; v < light_.size(); ++v) {
      light_[v] /= std::max(1.0, count[v]);
    }
  }

  double at(std::uint32_t face, const glm::dvec3& point) const {
    double most = -std::numeric_limits<double>::infinity(), shown = 0;
    for (const std::size_t t : of_face_[face]) {
      const glm::dvec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2),
                       normal = glm::cross(b - a, c - a);
      const double whole = glm::dot(normal, normal);
      const double of_a = glm::dot(normal, glm::cross(b - point, c - point)) / whole;
      const double of_b = glm::dot(normal, glm::cross(c - point, a - point)) / whole;
      const double inside = std::min({of_a, of_b, 1 - of_a - of_b});
      if (inside > most) {
        most = inside;
        shown = of_a * light_[mesh_.triangles[t][0]] + of_b * light_[mesh_.triangles[t][1]] +
                (1 - of_a - of_b) * light_[mesh_.triangles[t][2]];
      }
    }
    return shown;
  }

 private:
  glm::dvec3 corner(std::size_t triangle, std::size_t k) const {
    return (mesh_.positions[mesh_.triangles[triangle][k]] - device_.grid.origin) * device_.grid.scale;
  }
  std::uint32_t face_of(const glm::dvec3& normal, const glm::dvec3& middle) const {
    for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
      const FaceFrame& frame = scene_.frames[f];
      if (glm::dot(normal, frame.normal) > 0.99 &&
          std::abs(glm::dot(frame.normal, middle - frame.height)) < 1.5 &&
          contains(frame.outline, frame.to_frame(middle))) {
        return f;
      }
    }
    return 0;
  }

  const PreparedScene& scene_;
  DeviceScene device_;
  SurfaceMesh mesh_;
  std::vector<double> light_;
  std::vector<std::vector<std::size_t>> of_face_;
};

}  // namespace

ShadingError shading_error(const PreparedScene& scene, const Meshing& meshing) {
  const DirectLight light(scene);
  const Shading shading(scene, light, meshing);
  double scene_area = 0, sum = 0;
  for (const FaceFrame& frame : scene.frames) {
    scene_area += area(frame.outline) * frame.unit_area();
  }
  ShadingError error = {};
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const FaceFrame& frame = scene.frames[f];
    const auto lifted = [&](glm::dvec2 st) { return frame.to_grid(st) + kLift * frame.normal; };
    std::vector<double> means;
    for (const CellElement& element : meshing.faces[f].elements) {
      means.push_back(0);
      for (std::uint32_t i = 0; i < kOfElement; ++i) {
        means.back() += light.irradiance(f, lifted(spread_point(element.outline, i))) / kOfElement;
      }
    }
    const auto points =
        static_cast<std::uint32_t>(kPoints * area(frame.outline) * frame.unit_area() / scene_area);
    const bool is_lamp = scene.model->materials[scene.faces[f].material].emission != glm::dvec3(0.0);
    for (std::uint32_t i = 0; i < points && !is_lamp; ++i) {
      const glm::dvec2 st = spread_point(frame.outline, 1000 + i);
      if (light.is_buried(f, lifted(st))) {
        continue;
      }
      const double truth = light.irradiance(f, lifted(st));
      const std::vector<CellElement>& elements = meshing.faces[f].elements;
      const auto own = std::find_if(elements.begin(), elements.end(),
                                    [&](const CellElement& e) { return contains(e.outline, st); });
      sum += truth;
      error.vertices += std::abs(shading.at(f, frame.to_grid(st)) - truth);
      error.elements += own == elements.end()
                            ? 0.0
                            : std::abs(means[static_cast<std::size_t>(own - elements.begin())] - truth);
    }
  }
  return {error.vertices / sum, error.elements / sum};
}

}  // namespace fixrad::host

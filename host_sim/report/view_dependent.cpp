// SPDX-License-Identifier: MIT
#include "host_sim/report/view_dependent.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace fixrad::host {
namespace {

/// What lies this near a mirror's plane lies in it, as a part of the distance of the farthest vertex from it.
constexpr double kInPlane = 1e-4;

struct Corner {
  glm::dvec3 position, normal, radiosity;
  double height;
};

Corner between(const Corner& a, const Corner& b) {
  const double t = a.height / (a.height - b.height);
  return {a.position + t * (b.position - a.position), a.normal + t * (b.normal - a.normal),
          a.radiosity + t * (b.radiosity - a.radiosity), 0.0};
}

// Sutherland and Hodgman, against the mirror's plane.
std::vector<Corner> part_before(const std::vector<Corner>& polygon) {
  std::vector<Corner> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (a.height >= 0.0) {
      result.push_back(a);
    }
    if ((a.height >= 0.0) != (b.height >= 0.0)) {
      result.push_back(between(a, b));
    }
  }
  return result;
}

void append_fan(const std::vector<Corner>& polygon, std::uint32_t appearance, BakedMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Corner& corner : polygon) {
    mesh.positions.push_back(corner.position);
    mesh.normals.push_back(corner.normal);
    mesh.radiosity.push_back(corner.radiosity);
  }
  for (std::uint32_t k = 2; k < polygon.size(); ++k) {
    mesh.triangles.push_back({first, first + k - 1, first + k});
    mesh.triangle_appearance.push_back(appearance);
  }
}

BakedMesh before_mirror(const BakedMesh& mesh, const MirrorPlane& plane) {
  const auto height = [&](const glm::dvec3& p) { return glm::dot(plane.normal, p) - plane.offset; };
  double farthest = 0.0;
  for (const glm::dvec3& p : mesh.positions) {
    farthest = std::max(farthest, height(p));
  }
  BakedMesh result;
  result.appearances = mesh.appearances;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::vector<Corner> polygon;
    double highest = 0.0;
    for (const std::uint32_t v : mesh.triangles[t]) {
      polygon.push_back({mesh.positions[v], mesh.normals[v], mesh.radiosity[v], height(mesh.positions[v])});
      highest = std::max(highest, polygon.back().height);
    }
    if (highest > kInPlane * farthest) {
      append_fan(part_before(polygon), mesh.triangle_appearance[t], result);
    }
  }
  return result;
}

glm::dvec3 normal_at(const BakedMesh& mesh, std::uint32_t triangle, const glm::dvec3& point) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const glm::dvec3 pa = mesh.positions[a], pb = mesh.positions[b], pc = mesh.positions[c];
  const glm::dvec3 cross = glm::cross(pb - pa, pc - pa);
  const double whole = glm::dot(cross, cross);
  const double second = glm::dot(glm::cross(pc - point, pa - point), cross) / whole;
  const double third = glm::dot(glm::cross(pa - point, pb - point), cross) / whole;
  return glm::normalize((1 - second - third) * mesh.normals[a] + second * mesh.normals[b] +
                        third * mesh.normals[c]);
}

void add_highlights(const BakedMesh& mesh, const std::vector<BakedLamp>& lamps, const Projection& projection,
                    SampleBand& band) {
  for (std::size_t i = 0; i < band.radiosity.size(); ++i) {
    if (!(band.inverse_distance[i] > 0.0)) {
      continue;
    }
    const std::uint32_t triangle = band.source[i];
    const Appearance& appearance = mesh.appearances[mesh.triangle_appearance[triangle]];
    if (appearance.is_mirror || appearance.exponent <= 0.0) {
      continue;
    }
    const glm::dvec3 point = projection.to_scene(band.centre(i), 1.0 / band.inverse_distance[i]);
    band.radiosity[i] +=
        highlights(lamps, appearance, point, normal_at(mesh, triangle, point), projection.eye());
  }
}

}  // namespace

ViewDependent::ViewDependent(const BakedMesh& mesh, const Projection& camera, double near_distance,
                             const glm::dvec3& background)
    : mesh_(mesh), camera_(camera), background_(background), mirrors_(find_mirrors(mesh)) {
  for (const MirrorPlane& plane : mirrors_.planes) {
    Image image{plane, before_mirror(mesh, plane), camera.mirrored(plane.normal, plane.offset), {}, {}};
    image.triangles = visible_triangles(image.mesh, image.projection, near_distance, &image.sources);
    images_.push_back(std::move(image));
  }
}

void ViewDependent::add(SampleBand& band) const {
  if (!mesh_.appearances.empty()) {
    add_highlights(mesh_, mesh_.lamps, camera_, band);
    add_images(band);
  }
}

void ViewDependent::add_images(SampleBand& band) const {
  for (std::uint32_t m = 0; m < images_.size(); ++m) {
    const Image& image = images_[m];
    const auto shows = [&](std::size_t i) {
      return band.inverse_distance[i] > 0.0 && mirrors_.of_triangle[band.source[i]] == m;
    };
    std::vector<std::size_t> samples;
    for (std::size_t i = 0; i < band.radiosity.size(); ++i) {
      if (shows(i)) {
        samples.push_back(i);
      }
    }
    if (samples.empty()) {
      continue;
    }
    SampleBand seen;
    seen.clear(band.width, band.first_row, band.rows);
    for (std::size_t t = 0; t < image.triangles.size(); ++t) {
      draw(image.triangles[t], seen, image.sources[t]);
    }
    add_highlights(image.mesh, mesh_.lamps, image.projection, seen);
    const glm::dvec3 specular = mesh_.appearances[image.plane.appearance].specular;
    for (const std::size_t i : samples) {
      band.radiosity[i] += specular * (seen.inverse_distance[i] > 0.0 ? seen.radiosity[i] : background_);
    }
  }
}

}  // namespace fixrad::host

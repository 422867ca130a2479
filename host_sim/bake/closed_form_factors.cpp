// SPDX-License-Identifier: MIT
#include "host_sim/bake/closed_form_factors.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lib/form_factor/area_points.h"
#include "lib/form_factor/contour.h"
#include "lib/form_factor/ray_blockers.h"

namespace fixrad::host {
namespace {

constexpr int kFewestPoints = 8, kMostPoints = 128;  // along an axis
constexpr double kConverged = 5e-5;                  // of the factor, between two rules
constexpr double kFacing = 1;                        // grid units before a plane that count as seen

glm::dvec3 grid_point(const Vec3& fine) {
  return glm::dvec3(fine.x, fine.y, fine.z) / static_cast<double>(kFineScale);
}

double polygon_area(const Polygon& polygon) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 first = grid_point(polygon.corner[0]);
  for (int k = 1; k + 1 < polygon.count; ++k) {
    sum += glm::cross(grid_point(polygon.corner[k]) - first, grid_point(polygon.corner[k + 1]) - first);
  }
  return glm::length(sum) / 2;
}

// Whether some corner lies before the plane of `face`: what lies in one plane does not see each other.
bool is_before(const Polygon& polygon, const Polygon& of_face, const fixrad::Face& face) {
  const glm::dvec3 normal = glm::dvec3(face.normal[0], face.normal[1], face.normal[2]) / double{kUnit};
  const glm::dvec3 point = grid_point(of_face.corner[0]);
  return std::any_of(polygon.corner, polygon.corner + polygon.count,
                     [&](const Vec3& p) { return glm::dot(grid_point(p) - point, normal) > kFacing; });
}

}  // namespace

ClosedFormFactors::ClosedFormFactors(const PreparedScene& scene, const DeviceScene& device)
    : device_(device), scene_(device.view()), parts_(scene.model->file_faces), views_(scene.faces.size()) {
  work_.views = views_.data();
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    for (const FacePart& piece : scene.faces[f].parts) {
      Part part = {f, {}, 0};
      for (const std::uint32_t v : piece.corners) {
        const glm::ivec3 p = scene.vertices.positions[v] * static_cast<int>(kFineScale);
        part.polygon.corner[part.polygon.count++] = {p.x, p.y, p.z};
      }
      part.area = polygon_area(part.polygon);
      parts_[piece.input_face % scene.model->file_faces].push_back(part);
    }
  }
}

bool ClosedFormFactors::is_free(const Part& from, const Part& to) {
  RayBlockers blockers(scene_, work_);
  blockers.enter_source(static_cast<std::uint16_t>(from.face), from.polygon);
  blockers.enter_target(static_cast<std::uint16_t>(to.face));
  return blockers.is_free();
}

double ClosedFormFactors::mean_factor(const Part& from, const Part& to, int points) const {
  const AreaPoints spread(from.polygon);
  const ContourPoint normal = contour_point(device_.faces[from.face], {0, 0, 0});
  double sum = 0;
  for (int i = 0; i < points * points; ++i) {
    const auto s = static_cast<std::uint16_t>((2 * (i % points) + 1) * 0x8000 / points);
    const auto t = static_cast<std::uint16_t>((2 * (i / points) + 1) * 0x8000 / points);
    sum += std::max(0, contour_factor({spread.at(s, t), normal.normal}, to.polygon));
  }
  return std::ldexp(sum, -kArcBits) / (points * points);
}

// The midpoint rule errs with the square of the distance of its points, so two rules tell of a third.
double ClosedFormFactors::exchange_area(const Part& a, const Part& b) const {
  if (!is_before(a.polygon, b.polygon, device_.faces[b.face]) ||
      !is_before(b.polygon, a.polygon, device_.faces[a.face])) {
    return 0;
  }
  const Part& from = a.area <= b.area ? a : b;
  const Part& to = a.area <= b.area ? b : a;
  double coarse = mean_factor(from, to, kFewestPoints), best = coarse;
  for (int points = 2 * kFewestPoints; points <= kMostPoints; points *= 2) {
    const double fine = mean_factor(from, to, points);
    const double change = fine - coarse;
    best = fine + change / 3;
    if (std::abs(change) <= 3 * kConverged * fine) {
      break;
    }
    coarse = fine;
  }
  return std::max(0.0, best) * from.area;
}

std::optional<double> ClosedFormFactors::factor(std::uint32_t i, std::uint32_t j) {
  double area = 0, exchanged = 0;
  for (const Part& from : parts_[i]) {
    area += from.area;
    for (const Part& to : parts_[j]) {
      if (from.face == to.face) {
        continue;
      }
      if (!is_free(from, to)) {
        return std::nullopt;
      }
      exchanged += exchange_area(from, to);
    }
  }
  return area > 0 ? exchanged / area : 0;
}

}  // namespace fixrad::host

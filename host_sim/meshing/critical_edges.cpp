// SPDX-License-Identifier: MIT
#include "host_sim/meshing/critical_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kNarrow = 1e-3;  // radians; a narrower sector or gap is rounding

using EdgeTable = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>;

glm::dvec3 at(const PreparedScene& scene, std::uint32_t v) {
  return glm::dvec3(scene.vertices.positions[v]);
}

std::vector<std::uint32_t> used_vertices(const PreparedScene& scene) {
  std::vector<bool> is_used(scene.vertices.positions.size(), false);
  for (const ConvexFace& face : scene.faces) {
    for (const std::uint32_t v : face.corners) {
      is_used[v] = true;
    }
  }
  std::vector<std::uint32_t> used;
  for (std::uint32_t v = 0; v < is_used.size(); ++v) {
    if (is_used[v]) {
      used.push_back(v);
    }
  }
  return used;
}

/// The vertices along an edge, both ends included.
std::vector<std::uint32_t> vertices_along(const PreparedScene& scene, const std::vector<std::uint32_t>& used,
                                          std::uint32_t p, std::uint32_t q) {
  const glm::dvec3 start = at(scene, p), edge = at(scene, q) - start;
  const double squared = glm::dot(edge, edge);
  std::vector<std::pair<double, std::uint32_t>> inner;
  for (const std::uint32_t v : used) {
    const glm::dvec3 d = at(scene, v) - start;
    const double along = glm::dot(d, edge);
    if (v != p && v != q && along > 0 && along < squared &&
        glm::length(d - edge * (along / squared)) <= kOnPlane) {
      inner.emplace_back(along, v);
    }
  }
  std::sort(inner.begin(), inner.end());
  std::vector<std::uint32_t> result{p};
  for (const auto& [along, v] : inner) {
    result.push_back(v);
  }
  result.push_back(q);
  return result;
}

/// The border of a face with the T-vertices on it.
std::vector<std::uint32_t> border(const PreparedScene& scene, const std::vector<std::uint32_t>& used,
                                  const ConvexFace& face) {
  std::vector<std::uint32_t> corners;
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    const std::vector<std::uint32_t> side =
        vertices_along(scene, used, face.corners[k], face.corners[(k + 1) % face.corners.size()]);
    corners.insert(corners.end(), side.begin(), side.end() - 1);
  }
  return corners;
}

/// Whether a point near the plane of a convex face lies on the face, farther from its border than rounding.
bool is_inside(const PreparedScene& scene, std::size_t f, const glm::dvec3& point) {
  const ConvexFace& face = scene.faces[f];
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    const glm::dvec3 a = at(scene, face.corners[k]);
    const glm::dvec3 edge = at(scene, face.corners[(k + 1) % face.corners.size()]) - a;
    if (glm::dot(glm::cross(face.normal, edge), point - a) <= kOnPlane * glm::length(edge)) {
      return false;
    }
  }
  return true;
}

bool stands_on_a_face(const PreparedScene& scene, const std::vector<CornerSector>& own,
                      std::uint32_t vertex) {
  const glm::dvec3 point = at(scene, vertex);
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    if (std::abs(glm::dot(scene.frames[f].normal, point - scene.frames[f].height)) <= kTouchingPlane &&
        !borders_on(own, f) && is_inside(scene, f, point)) {
      return true;
    }
  }
  return false;
}

/// An angle in (-pi, pi].
double wrapped(double angle) {
  while (angle <= -kPi) {
    angle += 2 * kPi;
  }
  while (angle > kPi) {
    angle -= 2 * kPi;
  }
  return angle;
}

/// Directions round a line of sight.
struct Turn {
  glm::dvec3 x, y;

  explicit Turn(const glm::dvec3& sight) {
    const glm::dvec3 axis =
        std::abs(sight.x) < std::abs(sight.y) ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    x = glm::normalize(glm::cross(sight, axis));
    y = glm::normalize(glm::cross(sight, x));
  }
  double angle(const glm::dvec3& d) const { return std::atan2(glm::dot(d, y), glm::dot(d, x)); }
};

/// Whether sectors [from, to], each given in the turn that begins at -pi and in the next one, leave a part of
/// the turn from pi to 3 pi uncovered.
bool has_gap(std::vector<std::pair<double, double>>& covered) {
  std::sort(covered.begin(), covered.end());
  double reach = kPi;
  for (const auto& [from, to] : covered) {
    if (from > reach + kNarrow) {
      return true;
    }
    reach = std::max(reach, to);
  }
  return reach < 3 * kPi - kNarrow;
}

}  // namespace

bool borders_on(const std::vector<CornerSector>& sectors, std::uint32_t face) {
  return std::any_of(sectors.begin(), sectors.end(), [&](const CornerSector& s) { return s.face == face; });
}

SceneEdges find_edges(const PreparedScene& scene) {
  SceneEdges result;
  const std::vector<std::uint32_t> used = used_vertices(scene);
  result.sectors.resize(scene.vertices.positions.size());
  EdgeTable table;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const std::vector<std::uint32_t> corners = border(scene, used, scene.faces[f]);
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t v = corners[k], next = corners[(k + 1) % n];
      table[std::minmax(v, next)].push_back(f);
      result.sectors[v].push_back({f, corners[(k + n - 1) % n], next});
    }
  }
  for (auto& [ends, faces] : table) {
    result.edges.push_back({ends.first, ends.second, std::move(faces)});
  }
  result.is_on_a_face.resize(scene.vertices.positions.size(), false);
  for (const std::uint32_t v : used) {
    result.is_on_a_face[v] = stands_on_a_face(scene, result.sectors[v], v);
  }
  return result;
}

bool is_on_silhouette(const PreparedScene& scene, const SceneEdges& edges, std::uint32_t vertex,
                      const glm::dvec3& eye) {
  const glm::dvec3 point = at(scene, vertex);
  const Turn turn(point - eye);
  std::vector<std::pair<double, double>> covered;  // from, to; from in (-pi, pi]
  for (const CornerSector& sector : edges.sectors[vertex]) {
    const double first = turn.angle(at(scene, sector.before) - point);
    double width = wrapped(turn.angle(at(scene, sector.after) - point) - first);
    const double middle = wrapped(turn.angle(scene.frames[sector.face].height - point) - first);
    if (std::abs(std::abs(width) - kPi) < kNarrow && std::abs(std::sin(middle)) > kNarrow) {
      width = middle > 0 ? kPi : -kPi;
    }
    if (std::abs(width) >= kNarrow && std::abs(std::sin(middle)) >= kNarrow / 2) {
      const double from = width > 0 ? first : wrapped(first + width);
      covered.emplace_back(from, from + std::abs(width));
      covered.emplace_back(from + 2 * kPi, from + 2 * kPi + std::abs(width));
    }
  }
  return !covered.empty() && has_gap(covered);
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/bake/occlusion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace fixrad::host {
namespace {

constexpr double kTouch = 2;  // grid units: rounded corners, and planes through them

using Points = std::vector<glm::dvec3>;

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

Extent extent(const Points& points, const glm::dvec3& axis) {
  Extent e;
  for (const glm::dvec3& p : points) {
    const double d = glm::dot(p, axis);
    e.low = std::min(e.low, d);
    e.high = std::max(e.high, d);
  }
  return e;
}

struct FlatFace {
  Points corners;
  glm::dvec3 normal;

  // Whether some of `other` is on the lit side.
  bool looks_at(const FlatFace& other) const {
    return extent(other.corners, normal).high > glm::dot(corners[0], normal) + kTouch;
  }
  bool has_on_both_sides(const Points& points) const {
    const Extent e = extent(points, normal);
    const double height = glm::dot(corners[0], normal);
    return e.low < height - kTouch && e.high > height + kTouch;
  }
};

bool separates(const glm::dvec3& axis, const Points& a, const Points& b) {
  const double length = glm::length(axis);
  if (length < 1e-9) {
    return false;
  }
  const Extent of_a = extent(a, axis / length), of_b = extent(b, axis / length);
  return of_a.high <= of_b.low + kTouch || of_b.high <= of_a.low + kTouch;
}

// Candidates for the normal of a plane between two convex bodies: normals of the faces, and across an edge of
// the one and a line between corners of the other.
bool is_apart(const FlatFace& blocker, const FlatFace& from, const FlatFace& to) {
  Points hull = from.corners;
  hull.insert(hull.end(), to.corners.begin(), to.corners.end());
  for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
                                 blocker.normal, from.normal, to.normal}) {
    if (separates(axis, blocker.corners, hull)) {
      return true;
    }
  }
  for (std::size_t i = 0; i < hull.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const glm::dvec3 line = hull[i] - hull[k];
      for (std::size_t c = 0; c < blocker.corners.size(); ++c) {
        const glm::dvec3 edge = blocker.corners[(c + 1) % blocker.corners.size()] - blocker.corners[c];
        if (separates(glm::cross(line, edge), blocker.corners, hull)) {
          return true;
        }
      }
      for (const FlatFace* side : {&from, &to}) {
        if (separates(glm::cross(line, side->normal), blocker.corners, hull)) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

std::optional<Occlusion> find_occlusion(const PreparedScene& scene) {
  std::vector<FlatFace> faces;
  for (const ConvexFace& face : scene.faces) {
    FlatFace flat;
    for (const std::uint32_t v : face.corners) {
      flat.corners.emplace_back(scene.vertices.positions[v]);
    }
    flat.normal = face.normal;
    faces.push_back(std::move(flat));
  }
  Points all;
  for (const glm::ivec3& p : scene.vertices.positions) {
    all.emplace_back(p);
  }
  const auto count = static_cast<std::uint32_t>(faces.size());
  for (std::uint32_t c = 0; c < count; ++c) {
    if (count < 3 || !faces[c].has_on_both_sides(all)) {
      continue;  // nothing can pass through a plane that everything lies on one side of
    }
    for (std::uint32_t a = 0; a < count; ++a) {
      for (std::uint32_t b = a + 1; b < count; ++b) {
        if (a == c || b == c || !faces[a].looks_at(faces[b]) || !faces[b].looks_at(faces[a])) {
          continue;
        }
        Points both = faces[a].corners;
        both.insert(both.end(), faces[b].corners.begin(), faces[b].corners.end());
        if (faces[c].has_on_both_sides(both) && !is_apart(faces[c], faces[a], faces[b])) {
          return Occlusion{c, a, b};
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace fixrad::host

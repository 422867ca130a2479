// SPDX-License-Identifier: MIT
#include "host_sim/meshing/convex_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "host_sim/io/limits.h"
#include "host_sim/meshing/triangulate.h"
#include "lib/scene/scene.h"

namespace fixrad::host {
namespace {

// Within the core's kPlaneTolerance of 3, with room for its rounded normal: half a unit of 2^-14 an axis over
// 16383 grid units is at most 1.5 units.
constexpr double kPlanar = 1.0;
constexpr double kConvex = 1.0;

glm::dvec3 at(const QuantisedVertices& vertices, std::uint32_t v) {
  return glm::dvec3(vertices.positions[v]);
}

std::vector<std::uint32_t> welded_corners(const Face& face, const QuantisedVertices& vertices) {
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t v : face.corners) {
    const std::uint32_t w = vertices.index_of[v];
    if (corners.empty() || corners.back() != w) {
      corners.push_back(w);
    }
  }
  while (corners.size() > 1 && corners.front() == corners.back()) {
    corners.pop_back();
  }
  return corners;
}

}  // namespace

glm::dvec3 polygon_normal(const QuantisedVertices& vertices, const std::vector<std::uint32_t>& corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = at(vertices, corners[i]) - at(vertices, corners[0]);
    const glm::dvec3 b = at(vertices, corners[(i + 1) % corners.size()]) - at(vertices, corners[0]);
    sum += glm::cross(a, b);
  }
  const double length = glm::length(sum);
  return length > 0 ? sum / length : glm::dvec3(0.0);
}

bool is_convex_and_planar(const QuantisedVertices& vertices, const std::vector<std::uint32_t>& corners) {
  const std::size_t n = corners.size();
  const glm::dvec3 normal = polygon_normal(vertices, corners);
  if (n < 3 || n > static_cast<std::size_t>(kMaxCorners) || normal == glm::dvec3(0.0) ||
      std::set<std::uint32_t>(corners.begin(), corners.end()).size() != n) {
    return false;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 a = at(vertices, corners[i]);
    const glm::dvec3 b = at(vertices, corners[(i + 1) % n]);
    const glm::dvec3 inward = glm::normalize(glm::cross(normal, b - a));
    if (std::abs(glm::dot(normal, a - at(vertices, corners[0]))) > kPlanar) {
      return false;
    }
    for (const std::uint32_t other : corners) {
      if (glm::dot(inward, at(vertices, other) - a) < -kConvex) {
        return false;
      }
    }
  }
  return true;
}

ConvexFaces make_convex(const Model& model, const QuantisedVertices& vertices) {
  ConvexFaces result;
  std::size_t collapsed = 0;
  int first_line = 0;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    const std::vector<std::uint32_t> corners = welded_corners(face, vertices);
    std::vector<std::vector<std::uint32_t>> pieces;
    if (is_convex_and_planar(vertices, corners)) {
      pieces.push_back(corners);
    } else if (corners.size() >= 3) {
      pieces = triangulate(vertices, corners);
    }
    for (const std::vector<std::uint32_t>& piece : pieces) {
      const auto input = static_cast<std::uint32_t>(f);
      result.faces.push_back(
          {piece, polygon_normal(vertices, piece), face.material, face.smoothing_group, {{input, piece}}});
    }
    if (result.faces.size() > kMaxPieces) {
      throw InputError(model.path + ":" + std::to_string(face.line) +
                       ": error: with this face there are more than " + std::to_string(kMaxPieces) +
                       " convex pieces; simplify the scene");
    }
    if (pieces.empty() && collapsed++ == 0) {
      first_line = face.line;
    }
  }
  if (collapsed > 0) {
    result.warnings.push_back(
        model.path + ":" + std::to_string(first_line) + ": warning: " + std::to_string(collapsed) +
        " face(s), this one first, have no area on the device's grid; they are left out");
  }
  return result;
}

}  // namespace fixrad::host

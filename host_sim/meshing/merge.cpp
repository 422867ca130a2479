// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "host_sim/meshing/convex_faces.h"

namespace fixrad::host {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr double kSameNormal = 0.99995;  // cosine of 0.6 degrees; planarity on the grid is checked besides

struct Candidate {
  double quality;  // how much of a rectangle the union is, 1 at best
  std::size_t a, b;
  std::vector<std::uint32_t> corners;
};

// The union of two polygons across their common edge, without the spurs that remain where they share several
// edges.
std::vector<std::uint32_t> join(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                                Edge edge) {
  std::vector<std::uint32_t> result;
  const auto start_a = static_cast<std::size_t>(std::find(a.begin(), a.end(), edge.second) - a.begin());
  const auto start_b = static_cast<std::size_t>(std::find(b.begin(), b.end(), edge.first) - b.begin());
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    result.push_back(a[(start_a + i) % a.size()]);
  }
  for (std::size_t i = 0; i + 1 < b.size(); ++i) {
    result.push_back(b[(start_b + i) % b.size()]);
  }
  for (std::size_t i = 0; i < result.size() && result.size() > 3;) {
    const std::size_t n = result.size();
    if (result[i] == result[(i + 2) % n]) {
      const std::size_t spur = (i + 1) % n;
      const std::size_t twin = (i + 2) % n;
      result.erase(result.begin() + static_cast<std::ptrdiff_t>(std::max(spur, twin)));
      result.erase(result.begin() + static_cast<std::ptrdiff_t>(std::min(spur, twin)));
      i = 0;
    } else {
      ++i;
    }
  }
  return result;
}

// Area over the area of the smallest box along one of the polygon's edges.
double rectangularity(const QuantisedVertices& vertices, const std::vector<std::uint32_t>& corners,
                      glm::dvec3 normal) {
  double best = 0;
  const auto at = [&](std::uint32_t v) { return glm::dvec3(vertices.positions[v]); };
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    doubled +=
        glm::dot(normal, glm::cross(at(corners[i]) - at(corners[0]), at(corners[i + 1]) - at(corners[0])));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 u = glm::normalize(at(corners[(i + 1) % corners.size()]) - at(corners[i]));
    const glm::dvec3 v = glm::cross(normal, u);
    double u0 = 0, u1 = 0, v1 = 0;
    for (const std::uint32_t c : corners) {
      const glm::dvec3 d = at(c) - at(corners[i]);
      u0 = std::min(u0, glm::dot(d, u));
      u1 = std::max(u1, glm::dot(d, u));
      v1 = std::max(v1, glm::dot(d, v));
    }
    best = std::max(best, doubled / 2 / ((u1 - u0) * v1 + 1e-9));
  }
  return best;
}

std::vector<Candidate> find_candidates(const QuantisedVertices& vertices,
                                       const std::vector<ConvexFace>& faces) {
  std::map<Edge, std::size_t> owner;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < faces[f].corners.size(); ++i) {
      owner[{faces[f].corners[i], faces[f].corners[(i + 1) % faces[f].corners.size()]}] = f;
    }
  }
  std::vector<Candidate> candidates;
  for (const auto& [edge, a] : owner) {
    const auto it = owner.find({edge.second, edge.first});
    if (it == owner.end() || it->second <= a) {
      continue;
    }
    const std::size_t b = it->second;
    if (faces[a].material != faces[b].material || faces[a].smoothing_group != faces[b].smoothing_group ||
        glm::dot(faces[a].normal, faces[b].normal) < kSameNormal) {
      continue;
    }
    std::vector<std::uint32_t> corners = join(faces[a].corners, faces[b].corners, edge);
    if (is_convex_and_planar(vertices, corners)) {
      candidates.push_back({rectangularity(vertices, corners, faces[a].normal), a, b, std::move(corners)});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& x, const Candidate& y) { return x.quality > y.quality; });
  return candidates;
}

}  // namespace

void merge_coplanar(const QuantisedVertices& vertices, ConvexFaces& convex) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<ConvexFace>& faces = convex.faces;
    std::vector<bool> touched(faces.size(), false), gone(faces.size(), false);
    for (Candidate& candidate : find_candidates(vertices, faces)) {
      if (touched[candidate.a] || touched[candidate.b]) {
        continue;
      }
      touched[candidate.a] = touched[candidate.b] = gone[candidate.b] = changed = true;
      ConvexFace& kept = faces[candidate.a];
      kept.corners = std::move(candidate.corners);
      kept.normal = polygon_normal(vertices, kept.corners);
      for (FacePart& part : faces[candidate.b].parts) {
        kept.parts.push_back(std::move(part));
      }
    }
    std::vector<ConvexFace> rest;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!gone[f]) {
        rest.push_back(std::move(faces[f]));
      }
    }
    faces = std::move(rest);
  }
}

}  // namespace fixrad::host

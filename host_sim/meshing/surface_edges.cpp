// SPDX-License-Identifier: MIT
#include "host_sim/meshing/surface_edges.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

namespace fixrad::host {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Triangle = std::array<std::uint32_t, 3>;

Pair ordered(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

// The corner from which the triangle's longest edge starts. Of equal ones both neighbours choose alike.
std::size_t longest(const SurfaceMesh& mesh, const Triangle& t) {
  std::size_t best = 0;
  std::pair<double, Pair> most = {-1.0, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const Pair edge = ordered(t[k], t[(k + 1) % 3]);
    const std::pair<double, Pair> length = {
        glm::distance(mesh.positions[edge.first], mesh.positions[edge.second]), edge};
    if (length > most) {
      most = length;
      best = k;
    }
  }
  return best;
}

using Middles = std::map<Pair, std::uint32_t>;

// Cuts `t` at its longest edge, if it is to be cut at all, and the halves at the other edges.
std::vector<Triangle> cut(const SurfaceMesh& mesh, const Middles& middles, const Triangle& t) {
  const std::size_t k = longest(mesh, t);
  const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
  const auto ab = middles.find(ordered(a, b)), bc = middles.find(ordered(b, c)),
             ca = middles.find(ordered(c, a));
  if (ab == middles.end()) {
    return {t};
  }
  const std::uint32_t m = ab->second;
  std::vector<Triangle> parts;
  if (bc == middles.end()) {
    parts.push_back({m, b, c});
  } else {
    parts.insert(parts.end(), {{m, b, bc->second}, {m, bc->second, c}});
  }
  if (ca == middles.end()) {
    parts.push_back({m, c, a});
  } else {
    parts.insert(parts.end(), {{m, c, ca->second}, {m, ca->second, a}});
  }
  return parts;
}

std::uint32_t add_middle(SurfaceMesh& mesh, const SurfaceEdge& edge) {
  const auto v = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(middle_of(mesh, edge));
  mesh.normals.push_back(glm::normalize(mesh.normals[edge.a] + mesh.normals[edge.b]));
  mesh.vertices.push_back({static_cast<std::uint32_t>(mesh.elements.size()), kNoVertex,
                           static_cast<std::uint8_t>(edge.elements.size())});
  mesh.elements.insert(mesh.elements.end(), edge.elements.begin(), edge.elements.end());
  return v;
}

}  // namespace

std::vector<SurfaceEdge> surface_edges(const SurfaceMesh& mesh) {
  std::map<Pair, std::vector<std::uint16_t>> found;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<std::uint16_t>& elements =
          found[ordered(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3])];
      const std::uint16_t element = mesh.triangle_elements[t];
      const auto at = std::lower_bound(elements.begin(), elements.end(), element);
      if (at == elements.end() || *at != element) {
        elements.insert(at, element);
      }
    }
  }
  std::vector<SurfaceEdge> edges;
  edges.reserve(found.size());
  for (auto& [ends, elements] : found) {
    edges.push_back({ends.first, ends.second, std::move(elements)});
  }
  return edges;
}

glm::dvec3 middle_of(const SurfaceMesh& mesh, const SurfaceEdge& edge) {
  return 0.5 * (mesh.positions[edge.a] + mesh.positions[edge.b]);
}

std::vector<SurfaceEdge> with_longest(const SurfaceMesh& mesh, const std::vector<SurfaceEdge>& edges) {
  std::set<Pair> chosen;
  for (const SurfaceEdge& edge : edges) {
    chosen.insert({edge.a, edge.b});
  }
  for (bool grows = true; grows;) {
    grows = false;
    for (const Triangle& t : mesh.triangles) {
      const std::size_t k = longest(mesh, t);
      const Pair edge = ordered(t[k], t[(k + 1) % 3]);
      const bool is_cut = chosen.count(ordered(t[0], t[1])) + chosen.count(ordered(t[1], t[2])) +
                              chosen.count(ordered(t[2], t[0])) >
                          0;
      grows = (is_cut && chosen.insert(edge).second) || grows;
    }
  }
  std::vector<SurfaceEdge> all;
  for (SurfaceEdge& edge : surface_edges(mesh)) {
    if (chosen.count({edge.a, edge.b}) > 0) {
      all.push_back(std::move(edge));
    }
  }
  return all;
}

void cut_edges(SurfaceMesh& mesh, const std::vector<SurfaceEdge>& edges) {
  Middles middles;
  for (const SurfaceEdge& edge : edges) {
    middles[{edge.a, edge.b}] = add_middle(mesh, edge);
  }
  std::vector<Triangle> triangles;
  std::vector<std::uint16_t> elements;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::vector<Triangle> parts = cut(mesh, middles, mesh.triangles[t]);
    triangles.insert(triangles.end(), parts.begin(), parts.end());
    elements.insert(elements.end(), parts.size(), mesh.triangle_elements[t]);
  }
  mesh.triangles = std::move(triangles);
  mesh.triangle_elements = std::move(elements);
}

}  // namespace fixrad::host

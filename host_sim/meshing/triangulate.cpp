// SPDX-License-Identifier: MIT
#include "host_sim/meshing/triangulate.h"

#include <geos_c.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <utility>

#include "host_sim/meshing/convex_faces.h"

namespace fixrad::host {
namespace {

struct Context {
  GEOSContextHandle_t handle = GEOS_init_r();
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { GEOS_finish_r(handle); }
};

struct GeometryDeleter {
  GEOSContextHandle_t handle;
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
};
using Geometry = std::unique_ptr<GEOSGeometry, GeometryDeleter>;

// The polygon along its dominant axis: integer coordinates, which GEOS returns unchanged.
struct Projection {
  int u, v;

  std::pair<int, int> operator()(glm::ivec3 p) const { return {p[u], p[v]}; }
};

Projection project_along(glm::dvec3 n) {
  const glm::dvec3 a(std::abs(n.x), std::abs(n.y), std::abs(n.z));
  if (a.x >= a.y && a.x >= a.z) {
    return n.x > 0 ? Projection{1, 2} : Projection{2, 1};
  }
  if (a.y >= a.z) {
    return n.y > 0 ? Projection{2, 0} : Projection{0, 2};
  }
  return n.z > 0 ? Projection{0, 1} : Projection{1, 0};
}

GEOSCoordSequence* ring(GEOSContextHandle_t h, const QuantisedVertices& vertices,
                        const std::vector<std::uint32_t>& corners, Projection project) {
  const auto n = static_cast<unsigned>(corners.size());
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(h, n + 1, 2);
  for (unsigned i = 0; i <= n; ++i) {
    const auto [x, y] = project(vertices.positions[corners[i % n]]);
    GEOSCoordSeq_setXY_r(h, sequence, i, x, y);
  }
  return sequence;
}

std::vector<std::uint32_t> triangle_corners(GEOSContextHandle_t h, const GEOSGeometry* triangle,
                                            const std::map<std::pair<int, int>, std::uint32_t>& by_position) {
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(h, GEOSGetExteriorRing_r(h, triangle));
  std::vector<std::uint32_t> corners;
  for (unsigned i = 0; i < 3; ++i) {
    double x = 0, y = 0;
    GEOSCoordSeq_getXY_r(h, sequence, i, &x, &y);
    const auto it = by_position.find({static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))});
    if (it != by_position.end()) {
      corners.push_back(it->second);
    }
  }
  return corners;
}

using Triangles = std::vector<std::vector<std::uint32_t>>;

Triangles fan(const std::vector<std::uint32_t>& corners) {
  Triangles triangles;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
  return triangles;
}

Triangles delaunay(const QuantisedVertices& vertices, const std::vector<std::uint32_t>& corners,
                   glm::dvec3 normal) {
  const Context context;
  GEOSContextHandle_t h = context.handle;
  const Projection project = project_along(normal);
  std::map<std::pair<int, int>, std::uint32_t> by_position;
  for (const std::uint32_t v : corners) {
    by_position.emplace(project(vertices.positions[v]), v);
  }
  GEOSGeometry* shell = GEOSGeom_createLinearRing_r(h, ring(h, vertices, corners, project));
  const Geometry polygon(GEOSGeom_createPolygon_r(h, shell, nullptr, 0), {h});
  if (by_position.size() != corners.size() || polygon == nullptr || GEOSisValid_r(h, polygon.get()) != 1) {
    return {};
  }
  const Geometry mesh(GEOSConstrainedDelaunayTriangulation_r(h, polygon.get()), {h});
  Triangles triangles;
  const int count = mesh == nullptr ? 0 : GEOSGetNumGeometries_r(h, mesh.get());
  for (int i = 0; i < count; ++i) {
    triangles.push_back(triangle_corners(h, GEOSGetGeometryN_r(h, mesh.get(), i), by_position));
    if (triangles.back().size() != 3) {
      return {};
    }
  }
  return triangles;
}

}  // namespace

Triangles triangulate(const QuantisedVertices& vertices, const std::vector<std::uint32_t>& corners) {
  const glm::dvec3 normal = polygon_normal(vertices, corners);
  Triangles triangles;
  if (normal != glm::dvec3(0.0) && corners.size() > 3) {
    triangles = delaunay(vertices, corners, normal);
  }
  if (triangles.empty()) {
    triangles = fan(corners);
  }
  Triangles result;
  for (std::vector<std::uint32_t>& t : triangles) {
    const glm::dvec3 n = polygon_normal(vertices, t);
    if (glm::dot(n, normal) < 0) {
      std::swap(t[1], t[2]);
    }
    if (is_convex_and_planar(vertices, t)) {
      result.push_back(t);
    }
  }
  return result;
}

}  // namespace fixrad::host

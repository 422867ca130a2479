// SPDX-License-Identifier: MIT
#include "host_sim/meshing/surface_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

SurfaceMesh cornell_surface() {
  SolveOptions options;
  options.elements = 120;
  const Solution solution(cornell(), options);
  return make_surface_mesh(solution.prepared(), solution.device());
}

glm::dvec3 doubled_area(const SurfaceMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
}

double area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sum += 0.5 * glm::length(doubled_area(mesh, t));
  }
  return sum;
}

double smallest_sine(const SurfaceMesh& mesh) {
  double smallest = 1;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, glm::distance(mesh.positions[mesh.triangles[t][k]],
                                                mesh.positions[mesh.triangles[t][(k + 1) % 3]]));
    }
    smallest = std::min(smallest, glm::length(doubled_area(mesh, t)) / (longest * longest));
  }
  return smallest;
}

// Cuts every third edge, five times over.
SurfaceMesh cut_often(SurfaceMesh mesh) {
  for (int round = 0; round < 5; ++round) {
    std::vector<SurfaceEdge> some;
    const std::vector<SurfaceEdge> all = surface_edges(mesh);
    for (std::size_t i = 0; i < all.size() && some.size() < 40; i += 3) {
      some.push_back(all[i]);
    }
    cut_edges(mesh, with_longest(mesh, some));
  }
  return mesh;
}

TEST(SurfaceEdges, CutsKeepTheAreaAndTheLitSideOfEveryTriangle) {
  const SurfaceMesh before = cornell_surface(), after = cut_often(before);
  EXPECT_GT(after.triangles.size(), before.triangles.size() + 200);
  EXPECT_NEAR(area(after), area(before), 1e-9 * area(before));
  for (std::size_t t = 0; t < after.triangles.size(); ++t) {
    const glm::dvec3 normal = after.normals[after.triangles[t][0]];
    ASSERT_GT(glm::dot(doubled_area(after, t), normal), 0) << t;
  }
}

TEST(SurfaceEdges, CutsLeaveNoVertexOnAnEdgeSoNothingCracks) {
  const SurfaceMesh mesh = cut_often(cornell_surface());
  for (const SurfaceEdge& edge : surface_edges(mesh)) {
    for (const auto& [a, b, c] : mesh.triangles) {
      for (const std::uint32_t v : {a, b, c}) {
        if (v == edge.a || v == edge.b || glm::dot(mesh.normals[v], mesh.normals[edge.a]) < 0.999) {
          continue;
        }
        const double detour = glm::distance(mesh.positions[v], mesh.positions[edge.a]) +
                              glm::distance(mesh.positions[v], mesh.positions[edge.b]) -
                              glm::distance(mesh.positions[edge.a], mesh.positions[edge.b]);
        // A vertex of another surface in the same plane may lie there; one of this surface must not.
        const bool is_own = mesh.elements[mesh.vertices[v].first] == edge.elements.front();
        ASSERT_TRUE(!is_own || detour > 1e-9) << v << " on " << edge.a << '-' << edge.b;
      }
    }
  }
}

TEST(SurfaceEdges, LongestEdgesFirstKeepTrianglesFromDegenerating) {
  const SurfaceMesh before = cornell_surface();
  // Bisection of longest edges halves no angle twice (Rosenberg & Stenger 1975).
  EXPECT_GE(smallest_sine(cut_often(before)), 0.25 * smallest_sine(before));
}

TEST(SurfaceEdges, MiddlesMeetTheElementsOnBothSides) {
  SurfaceMesh mesh = cornell_surface();
  const std::size_t count = mesh.positions.size();
  const std::vector<SurfaceEdge> edges = with_longest(mesh, {surface_edges(mesh).front()});
  cut_edges(mesh, edges);
  ASSERT_EQ(mesh.positions.size(), count + edges.size());
  ASSERT_EQ(mesh.vertices.size(), mesh.positions.size());
  ASSERT_EQ(mesh.triangle_elements.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const MeshVertex& v = mesh.vertices[count + i];
    ASSERT_EQ(v.count, edges[i].elements.size());
    EXPECT_TRUE(
        std::equal(edges[i].elements.begin(), edges[i].elements.end(), mesh.elements.begin() + v.first));
  }
}

}  // namespace
}  // namespace fixrad::host

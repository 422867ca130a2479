// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

// Walls under a small lamp; the tests write the received flux themselves.
Model walls(const std::vector<std::vector<glm::dvec3>>& polygons, bool own_materials) {
  ModelBuilder builder;
  const std::uint32_t lamp = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  std::uint32_t wall = builder.material(glm::dvec3(0.5));
  builder.polygon({{-2, 3, -2}, {-1.9, 3, -2}, {-1.9, 3, -1.9}, {-2, 3, -1.9}}, lamp);
  for (const std::vector<glm::dvec3>& corners : polygons) {
    builder.polygon(corners, wall);
    wall = own_materials ? builder.material(glm::dvec3(0.5)) : wall;
  }
  return builder.model();
}

const std::vector<glm::dvec3> kFloor = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
const std::vector<glm::dvec3> kWall = {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
const std::vector<glm::dvec3> kNextFloor = {{1, 0, 0}, {1, 0, 1}, {2, 0, 1}, {2, 0, 0}};

class Painted : public Solution {
 public:
  explicit Painted(const Model& model)
      : Solution(model, options()), mesh_(make_surface_mesh(prepared(), device())) {}

  /// Gives every wall element a radiosity of value(centroid) (any unit), by what it has received.
  void paint(const std::function<double(glm::dvec3)>& value) {
    State& s = state();
    for (std::size_t e = 0; e < device().elements.size(); ++e) {
      const MeshElement& element = device().mesh.elements[e];
      s.received[e] = static_cast<std::int32_t>(std::lround(value(element.centroid) * element.area * kScale));
    }
    unit_ = static_cast<double>(radiosity_raw(last_element())) /
            value(device().mesh.elements[last_element()].centroid);
  }

  double at(std::size_t vertex) const {
    const VertexMap map = mesh_.map();
    return vertex_radiosity(state(), map, static_cast<std::uint32_t>(vertex), 0, Radiosity::from_raw(0)).raw /
           unit_;
  }

  const SurfaceMesh& mesh() const { return mesh_; }

 private:
  static constexpr double kScale = 1e7;

  static SolveOptions options() {
    SolveOptions options;
    options.elements = 80;
    return options;
  }
  std::size_t last_element() const { return device().elements.size() - 1; }
  std::uint32_t radiosity_raw(std::size_t e) const {
    return element_radiosity(state(), static_cast<std::uint16_t>(e), 0, Radiosity::from_raw(0)).raw;
  }

  SurfaceMesh mesh_;
  double unit_ = 1;
};

constexpr double kRounding = 1e-3;  // elements' areas are rounded to 1/8 square grid unit, fluxes to a unit

TEST(VertexRadiosity, ReproducesALinearGradientInsideAndAtTheBorder) {
  Painted solution(walls({kFloor}, false));
  const auto gradient = [](glm::dvec3 p) { return 5 + 3 * p.x + 2 * p.z; };
  solution.paint(gradient);
  int inside = 0, border = 0;
  for (std::size_t v = 0; v < solution.mesh().positions.size(); ++v) {
    const glm::dvec3 p = solution.mesh().positions[v];
    if (p.y < 1) {
      EXPECT_NEAR(solution.at(v), gradient(p), 10 * kRounding) << p.x << ' ' << p.z;
      ++(solution.mesh().vertices[v].inner == kNoVertex ? inside : border);
    }
  }
  EXPECT_GE(inside, 9);
  EXPECT_GE(border, 12);
}

TEST(VertexRadiosity, DoesNotBleedAcrossACrease) {
  Painted solution(walls({kFloor, kWall}, false));
  solution.paint([](glm::dvec3 p) { return p.x > 1e-6 ? 7.0 : 1.0; });  // the wall stands at x = 0
  int at_crease = 0;
  for (std::size_t v = 0; v < solution.mesh().positions.size(); ++v) {
    const glm::dvec3 p = solution.mesh().positions[v];
    if (p.y > 2) {
      continue;
    }
    const bool is_floor = solution.mesh().normals[v].y > 0.5;
    EXPECT_NEAR(solution.at(v), is_floor ? 7.0 : 1.0, 7 * kRounding);
    at_crease += std::abs(p.x) < 1e-3 && std::abs(p.y) < 1e-3 ? 1 : 0;
  }
  EXPECT_GE(at_crease, 4) << "the crease has vertices of either wall";
}

TEST(VertexRadiosity, DoesNotBleedAcrossMaterials) {
  Painted solution(walls({kFloor, kNextFloor}, true));
  solution.paint([](glm::dvec3 p) { return p.x < 1 ? 7.0 : 1.0; });
  for (std::size_t v = 0; v < solution.mesh().positions.size(); ++v) {
    const glm::dvec3 p = solution.mesh().positions[v];
    if (p.y < 2 && std::abs(p.x - 1) > 1e-3) {
      EXPECT_NEAR(solution.at(v), p.x < 1 ? 7.0 : 1.0, 7 * kRounding);
    } else if (p.y < 2) {
      EXPECT_GT(std::abs(solution.at(v) - 4.0), 2.9) << "a mean across the border";
    }
  }
}

TEST(VertexRadiosity, IsSmoothAcrossCoplanarFacesOfOneMaterial) {
  Painted solution(walls({kFloor, kNextFloor}, false));
  const auto gradient = [](glm::dvec3 p) { return 5 + 3 * p.x; };
  solution.paint(gradient);
  for (std::size_t v = 0; v < solution.mesh().positions.size(); ++v) {
    const glm::dvec3 p = solution.mesh().positions[v];
    if (p.y < 1) {
      EXPECT_NEAR(solution.at(v), gradient(p), 11 * kRounding);
    }
  }
}

TEST(VertexRadiosity, IsNeverNegative) {
  Painted solution(walls({kFloor}, false));
  solution.paint([](glm::dvec3 p) { return p.x < 0.3 ? 0.01 : 9.0; });  // extrapolation would go below zero
  double largest = 0;
  for (std::size_t v = 0; v < solution.mesh().positions.size(); ++v) {
    ASSERT_GE(solution.at(v), 0.0);
    largest = solution.mesh().positions[v].y < 1 ? std::max(largest, solution.at(v)) : largest;
  }
  EXPECT_LE(largest, 2 * 9.0 * (1 + kRounding)) << "at most twice the mean";
}

TEST(VertexRadiosity, TakesLentFluxAsDark) {
  Painted solution(walls({kFloor}, false));
  solution.paint([](glm::dvec3) { return 1.0; });
  for (std::size_t e = 0; e < solution.device().elements.size(); ++e) {
    solution.state().received[e] = -1000;
  }
  const VertexMap map = solution.mesh().map();
  for (std::uint32_t v = 0; v < map.vertex_count; ++v) {
    if (solution.mesh().positions[v].y < 1) {
      ASSERT_EQ(vertex_radiosity(solution.state(), map, v, 0, Radiosity::from_raw(0)).raw, 0u);
    }
  }
}

}  // namespace
}  // namespace fixrad::host

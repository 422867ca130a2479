// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/meshing/gather_points.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr Radiosity kNoAmbient[kMaxChannels] = {};
const DeltaTable& kFine = *lune_table(64);

std::vector<std::uint16_t> elements_round(const SurfaceMesh& mesh, std::size_t v) {
  const auto first = mesh.elements.begin() + mesh.vertices[v].first;
  return {first, first + mesh.vertices[v].count};
}

// A solved scene with its displayed mesh.
class Displayed : public Solution {
 public:
  explicit Displayed(const Model& model, std::uint32_t elements = 150)
      : Solution(model, options(elements)), mesh_(make_surface_mesh(prepared(), device())) {
    run();
  }

  const SurfaceMesh& mesh() const { return mesh_; }

  VertexLight gather(glm::dvec3 position, const std::vector<std::uint16_t>& elements) {
    const VertexGather at = vertex_gather(device(), position, elements);
    VertexLight light = {};
    EXPECT_EQ(gather_vertex(state(), kFine, correct_direct_light, at.points.data(),
                            static_cast<std::uint8_t>(at.points.size()), at.enough, kNoAmbient, light),
              Status::ok);
    return light;
  }
  VertexLight gather(std::size_t v) { return gather(mesh_.positions[v], elements_round(mesh_, v)); }

  /// The element of a floor (y = 0) whose centroid is nearest.
  std::uint16_t floor_element(glm::dvec3 p) const {
    std::size_t best = 0;
    double nearest = 1e9;
    for (std::size_t e = 0; e < device().elements.size(); ++e) {
      const MeshElement& element = device().mesh.elements[e];
      const double d = glm::distance(element.centroid, p);
      if (element.normal.y > 0.5 && element.centroid.y < 1e-3 && d < nearest) {
        nearest = d;
        best = e;
      }
    }
    return static_cast<std::uint16_t>(best);
  }

  double physical(Radiosity b) const { return b.raw * device().unit_radiosity; }

 private:
  static SolveOptions options(std::uint32_t elements) {
    SolveOptions options;
    options.elements = elements;
    options.settings = lune_settings(64, fraction(1, 10000));
    options.settings.flux_per_row = fraction(1, 100000);
    return options;
  }

  SurfaceMesh mesh_;
};

TEST(VertexGather, IsTheFurnacesRadiosityAtEveryVertexCornersToo) {
  Displayed furnace(cube(0.5, {1, 1, 1, 1, 1, 1}));
  for (std::size_t v = 0; v < furnace.mesh().positions.size(); ++v) {
    const VertexLight light = furnace.gather(v);
    EXPECT_GE(light.clear_points, 1);
    ASSERT_NEAR(furnace.physical(light.radiosity[0]), 2.0, 0.02) << v;  // E / (1 - rho)
    ASSERT_NEAR(furnace.physical(light.irradiance[0]), 2.0, 0.04) << v;
  }
}

// Configuration factor of a point to a parallel rectangle a x b at distance h with one corner over it (Siegel
// & Howell, catalogue B-3).
double parallel_factor(double a, double b, double h) {
  const double x = a / h, y = b / h;
  return (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
          y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y))) /
         (2 * std::acos(-1.0));
}

TEST(VertexGather, MatchesTheClosedFormUnderAParallelSquare) {
  Displayed lit(parallel_squares(0.0, 1.0, 0.5));
  for (std::size_t v = 0; v < lit.mesh().positions.size(); ++v) {
    const glm::dvec3 p = lit.mesh().positions[v];
    if (lit.mesh().normals[v].y > 0) {
      continue;  // the lamp itself
    }
    const double x = std::abs(p.x), z = std::abs(p.z);
    double factor = 0;
    for (const double a : {x, 1 - x}) {
      for (const double b : {z, 1 - z}) {
        factor += a > 0 && b > 0 ? parallel_factor(a, b, 1.0) : 0.0;
      }
    }
    ASSERT_NEAR(lit.physical(lit.gather(v).irradiance[0]), factor, 0.02 * factor) << p.x << ' ' << p.z;
  }
}

TEST(VertexGather, NeverExceedsTheBrightestElementNorFallsBelowTheOwnEmission) {
  Displayed room(cornell(), 250);
  std::uint32_t brightest[kMaxChannels] = {0, 0, 0};
  for (std::uint16_t e = 0; e < room.device().elements.size(); ++e) {
    for (int c = 0; c < kMaxChannels; ++c) {
      brightest[c] = std::max(brightest[c], element_radiosity(room.state(), e, c, kNoAmbient[c]).raw);
    }
  }
  for (std::size_t v = 0; v < room.mesh().positions.size(); ++v) {
    const VertexLight light = room.gather(v);
    for (int c = 0; c < kMaxChannels; ++c) {
      ASSERT_LE(light.irradiance[c].raw, brightest[c]) << v;
      const double emission = room.device().mesh.elements[elements_round(room.mesh(), v).front()].emission[c];
      ASSERT_GE(room.physical(light.radiosity[c]), emission * (1 - 1e-6)) << v;
    }
  }
}

// The middle of the floor of a room with a box on it, and a point of the floor that is free.
TEST(VertexGather, FindsAVertexUnderABoxBuriedAndOneBesideItClear) {
  for (const Stand stand : {Stand::without_bottom, Stand::closed_on_floor}) {
    Displayed room(room_with_box(stand, 0.0), 200);
    int under = 0, beside = 0;
    for (std::size_t v = 0; v < room.mesh().positions.size(); ++v) {
      const glm::dvec3 p = room.mesh().positions[v];
      if (room.mesh().normals[v].y < 0.5 || p.y > 1e-3) {
        continue;
      }
      const double off = std::max(std::abs(p.x - 2), std::abs(p.z - 2));
      const VertexLight light = room.gather(v);
      if (off < 0.4) {
        ++under;
        EXPECT_EQ(light.clear_points, 0);
        EXPECT_EQ(light.radiosity[0].raw, 0u);
      } else if (off > 0.6) {
        ++beside;
        EXPECT_GT(light.clear_points, 0);
        EXPECT_GT(light.radiosity[0].raw, 0u);
      }
    }
    EXPECT_GE(under, 1);
    EXPECT_GE(beside, 8);
  }
}

TEST(VertexGather, CountsOnlyTheLitSideWhereOnePointIsBuried) {
  Displayed room(room_with_box(Stand::without_bottom, 0.0), 200);
  const std::uint16_t lit = room.floor_element({0.5, 0, 0.5}), buried = room.floor_element({2, 0, 2});
  const GatherPoint points[] = {gather_point(room.device(), buried, {2, 0, 2}),
                                gather_point(room.device(), lit, room.device().mesh.elements[lit].centroid)};
  VertexLight both = {}, one = {};
  ASSERT_EQ(gather_vertex(room.state(), kFine, correct_direct_light, points, 2, 2, kNoAmbient, both),
            Status::ok);
  const GatherPoint alone[] = {points[1], points[1]};
  ASSERT_EQ(gather_vertex(room.state(), kFine, correct_direct_light, alone, 2, 2, kNoAmbient, one),
            Status::ok);
  EXPECT_EQ(both.clear_points, 1);
  EXPECT_EQ(one.clear_points, 2);
  EXPECT_NEAR(both.radiosity[0].raw, one.radiosity[0].raw, 0.03 * one.radiosity[0].raw);
}

TEST(VertexGather, LeavesTheSolutionAsItIs) {
  Displayed room(cornell(), 120);
  const std::uint64_t before = room.digest();
  const Ledger ledger_before = ledger(room.state(), 0);
  const VertexLight first = room.gather(0);
  for (std::size_t v = 1; v < 50; ++v) {
    room.gather(v);
  }
  const VertexLight again = room.gather(0);
  EXPECT_EQ(room.digest(), before);
  EXPECT_EQ(ledger(room.state(), 0).absorbed, ledger_before.absorbed);
  EXPECT_EQ(room.imbalance(), 0);
  for (int c = 0; c < kMaxChannels; ++c) {
    EXPECT_EQ(again.radiosity[c].raw, first.radiosity[c].raw)
        << "a vertex depends on nothing but the solution";
  }
}

TEST(DisplayDigest, IsThatOfTheMeansIfTheMeansAreDisplayed) {
  Displayed room(cornell(), 120);
  const VertexMap map = room.mesh().map();
  std::vector<Radiosity> means;
  for (std::uint32_t v = 0; v < map.vertex_count; ++v) {
    for (int c = 0; c < kMaxChannels; ++c) {
      means.push_back(vertex_radiosity(room.state(), map, v, c, kNoAmbient[c]));
    }
  }
  const auto count = static_cast<std::uint32_t>(means.size());
  EXPECT_EQ(digest(room.state(), means.data(), count), digest(room.state(), map));
  means.back() = Radiosity::from_raw(means.back().raw + 1);
  EXPECT_NE(digest(room.state(), means.data(), count), digest(room.state(), map));
}

}  // namespace
}  // namespace fixrad::host

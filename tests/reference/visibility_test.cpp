// SPDX-License-Identifier: MIT
#include "host_sim/reference/visibility.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <stdexcept>

#include "tests/reference/grid_mesh.h"

namespace fixrad::host {
namespace {

const glm::dvec3 kUp{0, 0, 1};

TEST(Visibility, ATriangleBlocksFromBothSides) {
  const RayScene scene({{-1, -1, 0.5}, {1, -1, 0.5}, {0, 1, 0.5}}, {0, 1, 2});
  EXPECT_FALSE(scene.visible({0, 0, 0}, kUp, {0, 0, 1}, -kUp));
  EXPECT_FALSE(scene.visible({0, 0, 1}, -kUp, {0, 0, 0}, kUp));
  EXPECT_TRUE(scene.visible({0, 2, 0}, kUp, {0, 2, 1}, -kUp));
}

TEST(Visibility, APacketSeesWhatItsRaysSee) {
  const RayScene scene({{-1, -1, 0.5}, {1, -1, 0.5}, {0, 1, 0.5}}, {0, 1, 2});
  glm::dvec3 p[RayScene::kPacket];
  glm::dvec3 q[RayScene::kPacket];
  for (std::size_t k = 0; k < RayScene::kPacket; ++k) {
    const double x = 0.4 * static_cast<double>(k) - 1.5;
    p[k] = {x, 0.1, 0};
    q[k] = {-0.3 * x, 0.2, 1};
  }
  for (std::size_t count = 0; count <= RayScene::kPacket; ++count) {
    std::uint32_t expected = 0;
    for (std::size_t k = 0; k < count; ++k) {
      expected |= scene.visible(p[k], kUp, q[k], -kUp) ? 1U << k : 0U;
    }
    EXPECT_EQ(scene.visible_packet(p, kUp, q, -kUp, count), expected) << count;
    EXPECT_TRUE(count < RayScene::kPacket || (expected != 0 && expected != 0xffU)) << "all alike";
  }
}

TEST(Visibility, WithoutBlockersEverythingIsVisible) {
  const RayScene scene({}, {});
  EXPECT_TRUE(scene.visible({0, 0, 0}, kUp, {0, 0, 1}, -kUp));
  EXPECT_FALSE(scene.nearest({0, 0, 0}, kUp, kUp).has_value());
}

TEST(Visibility, SurfacesDoNotBlockThemselvesAtGrazingAngles) {
  // Far from the origin and large, so that single precision alone could not tell the points from their
  // planes.
  ElementMesh mesh;
  const glm::dvec3 corner{12345.678, -9876.543, 4321.1};
  const double size = 100.0 / 3.0;
  add_grid(mesh, corner, {size, 0, 0}, {0, size, 0}, 1, 1, {});
  add_grid(mesh, corner, {0, size, 0}, {0, 0, size}, 1, 1, {});
  const RayScene scene(mesh.blocker_positions, mesh.blocker_triangles);
  for (double height = 1e-3; height < 1.0; height *= 1.3) {
    for (double distance = 1e-3; distance < 1.0; distance *= 1.3) {
      const glm::dvec3 p = corner + size * glm::dvec3{distance, 0.4, 0};
      const glm::dvec3 q = corner + size * glm::dvec3{0, 0.6, height};
      EXPECT_TRUE(scene.visible(p, kUp, q, {1, 0, 0})) << distance << ' ' << height;
    }
  }
}

TEST(Visibility, NearestGivesTriangleAndDistanceInSceneUnits) {
  const RayScene scene({{-10, -10, 7}, {10, -10, 7}, {0, 10, 7}, {-10, -10, 5}, {10, -10, 5}, {0, 10, 5}},
                       {0, 1, 2, 3, 4, 5});
  const auto hit = scene.nearest({0, 0, 0}, kUp, kUp);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->triangle, 1U);
  EXPECT_NEAR(hit->distance, 5.0, 1e-4);
}

TEST(Visibility, NearestTellsFrontFromBack) {
  const RayScene scene({{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}, {0, 1, 2});  // counter-clockwise seen from above
  EXPECT_TRUE(scene.nearest({0, 0, 2}, -kUp, -kUp)->front);
  EXPECT_FALSE(scene.nearest({0, 0, 0}, kUp, kUp)->front);
}

TEST(Visibility, ATwoSidedSheetShowsItsFrontFromEitherSide) {
  const RayScene scene({{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}, {0, 1, 2, 0, 2, 1});
  for (const double x : {-0.3, 0.0, 0.1, 0.3}) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3{x, -0.1, 1.0});
    const auto above = scene.nearest(glm::dvec3{0, 0, 1} + direction, -kUp, -direction);
    const auto below = scene.nearest(glm::dvec3{0, 0, 1} - direction, kUp, direction);
    ASSERT_TRUE(above.has_value() && below.has_value());
    EXPECT_TRUE(above->front && above->triangle == 0U) << x;
    EXPECT_TRUE(below->front && below->triangle == 1U) << x;
  }
}

TEST(Visibility, RefusesIndicesWithoutPositions) {
  EXPECT_THROW(RayScene({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 3}), std::runtime_error);
  EXPECT_THROW(RayScene({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1}), std::runtime_error);
}

}  // namespace
}  // namespace fixrad::host

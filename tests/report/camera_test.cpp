// SPDX-License-Identifier: MIT
#include "host_sim/report/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <stdexcept>

#include "host_sim/report/automatic_camera.h"
#include "tests/report/sample_mesh.h"

namespace fixrad::host {
namespace {

constexpr double kRounding = 1e-9;
constexpr double kAspect = 4.0 / 3.0;

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(a[k], b[k], kRounding);
  }
}

/// At 90 degrees the upper edge of the picture is one unit up at one unit's distance.
Camera right_angled() {
  return {{0, 0, 5}, {0, 0, 0}, 90.0};
}

TEST(Projection, PutsTheTargetInTheMiddleOfThePicture) {
  const Projection projection(right_angled(), false, 400, 200);
  const glm::dvec2 p = projection.to_pixels(projection.to_camera({0, 0, 0}));
  EXPECT_NEAR(p.x, 200.0, kRounding);
  EXPECT_NEAR(p.y, 100.0, kRounding);
}

TEST(Projection, PutsAKnownPointWhereSimilarTrianglesSay) {
  const Projection projection(right_angled(), false, 400, 200);
  // At distance 4 half the picture's height is 4 units, so a unit is 25 pixels.
  const glm::dvec3 in_camera = projection.to_camera({2, 3, 1});
  EXPECT_NEAR(in_camera.z, 4.0, kRounding);
  const glm::dvec2 p = projection.to_pixels(in_camera);
  EXPECT_NEAR(p.x, 200.0 + 2.0 * 25.0, kRounding);
  EXPECT_NEAR(p.y, 100.0 - 3.0 * 25.0, kRounding);
}

TEST(Projection, ShowsZUpwardsWhereZIsUp) {
  const Projection projection({{0, -5, 0}, {0, 0, 0}, 90.0}, true, 200, 200);
  const glm::dvec2 p = projection.to_pixels(projection.to_camera({1, 0, 2}));
  EXPECT_NEAR(p.x, 100.0 + 20.0, kRounding);
  EXPECT_NEAR(p.y, 100.0 - 40.0, kRounding);
}

TEST(Projection, LooksStraightDownWithoutTrouble) {
  const Projection projection({{0, 5, 0}, {0, 0, 0}, 90.0}, false, 200, 200);
  const glm::dvec2 p = projection.to_pixels(projection.to_camera({1, 0, 0}));
  EXPECT_NEAR(p.x, 120.0, kRounding);
  EXPECT_NEAR(p.y, 100.0, kRounding);
}

TEST(Projection, RefusesACameraThatLooksNowhere) {
  EXPECT_THROW(Projection({{1, 1, 1}, {1, 1, 1}, 40.0}, false, 10, 10), std::invalid_argument);
  EXPECT_THROW(Projection({{0, 0, 1}, {0, 0, 0}, 180.0}, false, 10, 10), std::invalid_argument);
  EXPECT_THROW(Projection({{0, 0, 1}, {0, 0, 0}, 0.0}, false, 10, 10), std::invalid_argument);
}

TEST(AutomaticCamera, LooksAlongTheAxisThroughTheOpenSideOfARoom) {
  const Camera camera = automatic_camera(testing::open_room(), false, kAspect);
  expect_near(glm::normalize(camera.target - camera.eye), {0, 0, 1});
  EXPECT_LT(camera.eye.z, 0.0);
  EXPECT_NEAR(camera.eye.x, 0.5, kRounding);
  EXPECT_NEAR(camera.eye.y, 0.5, kRounding);
}

TEST(AutomaticCamera, LooksThroughTheWidestWallOfAClosedRoom) {
  BakedMesh mesh = testing::open_room();
  testing::add_quad(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0.5});
  for (glm::dvec3& p : mesh.positions) {
    p.z *= 3.0;
  }
  const Camera camera = automatic_camera(mesh, false, kAspect);
  expect_near(glm::normalize(camera.target - camera.eye), {-1, 0, 0});
}

TEST(AutomaticCamera, LooksDownIntoARoomWithoutACeiling) {
  BakedMesh mesh = testing::open_room();
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  const Camera camera = automatic_camera(mesh, false, kAspect);
  EXPECT_GT(camera.eye.y, camera.target.y);
}

TEST(AutomaticCamera, LooksDownAtALitFloorAndUpAtALitCeiling) {
  BakedMesh floor;
  testing::add_quad(floor, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 1});
  BakedMesh ceiling;
  testing::add_quad(ceiling, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 1, 1});
  EXPECT_GT(automatic_camera(floor, false, kAspect).eye.y, 0.0);
  EXPECT_LT(automatic_camera(ceiling, false, kAspect).eye.y, 0.0);
}

TEST(AutomaticCamera, ShowsEveryVertexAndFillsThePictureOneWay) {
  for (const bool z_up : {false, true}) {
    const BakedMesh mesh = testing::open_room();
    const Projection projection(automatic_camera(mesh, z_up, kAspect), z_up, 400, 300);
    double reach = 0.0;
    for (const glm::dvec3& position : mesh.positions) {
      const glm::dvec3 in_camera = projection.to_camera(position);
      ASSERT_GT(in_camera.z, 0.0);
      const glm::dvec2 p = projection.to_pixels(in_camera);
      reach = std::max({reach, std::abs(p.x / 200.0 - 1.0), std::abs(p.y / 150.0 - 1.0)});
    }
    EXPECT_LT(reach, 1.0);
    EXPECT_GT(reach, 0.9);
  }
}

}  // namespace
}  // namespace fixrad::host

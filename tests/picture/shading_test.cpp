// SPDX-License-Identifier: MIT
#include "lib/picture/shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "lib/picture/clip.h"
#include "lib/picture/coverage.h"

namespace fixrad {
namespace {

constexpr int kSide = 200;

Projection looking_along_z() {
  PictureCamera camera = {};
  camera.right[0] = camera.up[1] = camera.forward[2] = 1 << 14;
  camera.focal = 256 * kSide / 2;  // 90 degrees
  camera.width = camera.height = kSide;
  return projection_of(camera);
}

glm::dvec3 in_double(const Vec3& v) {
  return {v.x, v.y, v.z};
}

// Distance and weights where the ray through a pixel's centre meets the plane of a triangle.
struct Met {
  double z, second, third;
};
Met meet(const Vec3 (&corner)[3], int x, int y) {
  const glm::dvec3 ray((x + 0.5) / (kSide / 2.0) - 1, 1 - (y + 0.5) / (kSide / 2.0), 1);
  const glm::dvec3 a = in_double(corner[0]), b = in_double(corner[1]), c = in_double(corner[2]);
  const double whole = glm::dot(ray, glm::cross(b, c) + glm::cross(c, a) + glm::cross(a, b));
  return {glm::dot(a, glm::cross(b, c)) / whole, glm::dot(ray, glm::cross(c, a)) / whole,
          glm::dot(ray, glm::cross(a, b)) / whole};
}

TEST(Shading, FindsDistanceAndWeightsWhereTheRayMeetsTheTriangle) {
  const Projection projection = looking_along_z();
  std::mt19937 random(3);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low));
  };
  int pixels = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Vec3 corner[3];
    ScreenCorner screen[3];
    for (int i = 0; i < 3; ++i) {
      const int z = between(1000, 400000);  // 1/16 grid unit
      corner[i] = {between(-z, z), between(-z, z), z};
      screen[i] = to_screen(projection, corner[i]);
    }
    std::int64_t area = screen_area(screen[0], screen[1], screen[2]);
    if (area < 0) {
      std::swap(screen[1], screen[2]);
      std::swap(corner[1], corner[2]);
      area = -area;
    }
    if (area < 20 * 65536) {
      continue;  // narrower than what rounding to 1/256 pixel leaves of it
    }
    TriangleShading shading(screen[0], screen[1], screen[2], area);
    Coverage(screen[0], screen[1], screen[2]).rows(0, kSide, kSide, [&](int32_t y, int32_t from, int32_t to) {
      shading.start(from, y);
      for (int32_t x = from; x < to; ++x, shading.step(), ++pixels) {
        const SurfacePoint point = shading.point();
        const Met met = meet(corner, x, y);
        // A corner off by half of 1/256 pixel moves the plane; a depth is 64 of the 1/16 units.
        ASSERT_NEAR(64.0 * point.depth, met.z, 64 + 0.01 * met.z) << trial;
        ASSERT_NEAR(std::ldexp(point.second, -14), met.second, 0.01) << trial;
        ASSERT_NEAR(std::ldexp(point.third, -14), met.third, 0.01) << trial;
      }
    });
  }
  EXPECT_GT(pixels, 100000);
}

TEST(Shading, GivesAPlaneAcrossTheViewOneDepth) {
  const Projection projection = looking_along_z();
  for (const int units : {100, 5000, 30000, 110000}) {
    const int z = units * 16;
    const ScreenCorner a = to_screen(projection, {-z, -z, z}), b = to_screen(projection, {z, -z, z}),
                       c = to_screen(projection, {z, z, z});
    TriangleShading shading(a, c, b, screen_area(a, c, b));
    for (int y = 100; y < 190; y += 7) {
      shading.start(195, y);
      EXPECT_NEAR(shading.point().depth, units / 4, 1 + units / 4 / 32768) << units;
    }
  }
}

TEST(Shading, InterpolatesBetweenTheExtremesOfItsRange) {
  EXPECT_EQ(interpolate({1, 1 << 14, 0}, 0, 65535, 0), 65535);
  EXPECT_EQ(interpolate({1, 0, 1 << 14}, 65535, 65535, 0), 0);
  EXPECT_EQ(interpolate({1, 1 << 12, 1 << 13}, 65535, 0, 65535), 49151);
}

TEST(Clip, CutsATriangleThatRunsBehindTheEyeAtTheNearPlane) {
  ViewPolygon polygon = {};
  polygon.count = 3;
  polygon.corner[0].at = {0, 0, 1600};
  polygon.corner[1].at = {0, 100, -1472};
  polygon.corner[2].at = {100, 0, -1472};
  polygon.corner[0].light[0] = 1000;
  ASSERT_TRUE(clip_to_view(looking_along_z(), polygon));
  ASSERT_EQ(polygon.count, 3);
  // Half of the way from 1600 to -1472 is kNearest = 64.
  EXPECT_EQ(polygon.corner[0].at.z, kNearest);
  EXPECT_EQ(polygon.corner[0].at.x, 50);
  EXPECT_EQ(polygon.corner[1].at.z, 1600) << "the turn is kept";
  EXPECT_EQ(polygon.corner[2].at.z, kNearest);
  EXPECT_EQ(polygon.corner[2].at.y, 50);
  EXPECT_EQ(polygon.corner[2].light[0], 500);
}

TEST(Clip, LeavesNothingOfWhatIsBehindTheEye) {
  ViewPolygon polygon = {};
  polygon.count = 3;
  polygon.corner[1].at = {10, 0, -5};
  polygon.corner[2].at = {0, 10, -5};
  EXPECT_FALSE(clip_to_view(looking_along_z(), polygon));
}

}  // namespace
}  // namespace fixrad

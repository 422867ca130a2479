// SPDX-License-Identifier: MIT
#include "lib/picture/highlight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/report/mirrors.h"
#include "tests/picture/device_mesh.h"

namespace fixrad::host::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A floor at height 0 of a grid, a lamp that looks down from (8000, 4000, 8000).
struct Room {
  PictureLamp lamp = {{32000, 16000, 32000}, {0, -16384, 0}, 8 * 200 * 200, {100 << 12, 50 << 12, 10 << 12}};
  PictureMaterial material = {{32768, 32768, 16384}, 40};
  PictureScene scene = {};

  Room() {
    scene.lamps = &lamp;
    scene.lamp_count = 1;
    scene.channels = 3;
  }
  std::array<double, 3> seen(Vec3 at, Vec3 eye) const {
    std::uint16_t light[3] = {0, 0, 0};
    add_highlights(scene, material, at, {0, 16384, 0}, eye, light);
    return {light[0] / 4096.0, light[1] / 4096.0, light[2] / 4096.0};
  }
};

TEST(Highlight, IsKsTimesHalfOfNPlusTwoTimesTheIrradianceInTheMirrorDirection) {
  const Room room;
  // The eye sees the lamp's mirror image in (6000, 0, 8000): both are 4000 over the floor, 2000 to either
  // side.
  const std::array<double, 3> seen = room.seen({6000, 0, 8000}, {4000, 4000, 8000});
  const double cosine = 4000 / std::hypot(4000, 2000);
  const double part = 200 * 200 * cosine * cosine / (kPi * (4000.0 * 4000 + 2000 * 2000));
  const double shape = 42.0 / 2;
  EXPECT_NEAR(seen[0], 0.5 * shape * 100 * part, 0.002 * seen[0]);
  EXPECT_NEAR(seen[1], 0.5 * shape * 50 * part, 0.002 * seen[0]);
  EXPECT_NEAR(seen[2], 0.25 * shape * 10 * part, 0.002 * seen[0]);
}

TEST(Highlight, FallsOffWithThePowerOfTheCosine) {
  const Room room;
  const Vec3 eye = {4000, 4000, 8000};
  const Appearance appearance = {{0.5, 0.5, 0.25}, 40, false};
  const std::vector<BakedLamp> lamps = {{{8000, 4000, 8000}, {0, -1, 0}, 200 * 200, {100, 50, 10}}};
  for (int x = 4000; x <= 9000; x += 250) {
    for (int z = 6500; z <= 9500; z += 500) {
      const glm::dvec3 exact =
          highlights(lamps, appearance, glm::dvec3(x, 0, z), {0, 1, 0}, {eye.x, eye.y, eye.z});
      EXPECT_NEAR(room.seen({x, 0, z}, eye)[0], exact.x, 0.002 + 0.005 * exact.x) << x << ' ' << z;
    }
  }
}

TEST(Highlight, IsNoneBehindTheSurfaceOrTheLamp) {
  Room room;
  const Vec3 at = {6000, 0, 8000};
  const std::array<double, 3> none = {0, 0, 0};
  EXPECT_EQ(room.seen(at, {4000, -4000, 8000}), none) << "the eye is behind the surface";
  room.lamp.normal[1] = 16384;
  EXPECT_EQ(room.seen(at, {4000, 4000, 8000}), none) << "the lamp looks away";
}

TEST(Highlight, ReflectsNoMoreThanKsOfWhatArrives) {
  // The sum over the hemisphere of directions of what leaves, B cos / pi, against the irradiance.
  Room room;
  room.material.exponent = 10;
  const Vec3 at = {8000, 0, 8000};  // straight under the lamp
  const double arriving = 100 * 200.0 * 200 / (kPi * 4000.0 * 4000);
  double leaving = 0;
  constexpr int kSteps = 60;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      // Equal areas of the unit disc (Nusselt's analogue): each direction stands for 1 / kSteps^2 of B.
      const double radius = std::sqrt((i + 0.5) / kSteps), turn = 2 * kPi * (j + 0.5) / kSteps;
      const auto along = [](double part) { return static_cast<int32_t>(std::lround(7000 * part)); };
      const Vec3 eye = {8000 + along(radius * std::cos(turn)), along(std::sqrt(1 - radius * radius)),
                        8000 + along(radius * std::sin(turn))};
      leaving += room.seen(at, eye)[0] / (kSteps * kSteps);
    }
  }
  EXPECT_NEAR(leaving, 0.5 * arriving, 0.01 * arriving);
}

TEST(DeviceRenderer, ShowsTheHighlightWhereTheMirrorDirectionMeetsTheFloor) {
  BakedMesh mesh;
  add_quad(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0.05, 0.05, 0.05});
  mesh.appearances = {{{0.1, 0.1, 0.1}, 300, false}};
  mesh.triangle_appearance = {0, 0};
  mesh.lamps = {{{0.5, 0.5, 0.1}, {0, -1, 0}, 1e-4, {100, 100, 100}}};
  const PictureOptions picture = {160, 120, Camera{{0.5, 0.5, 0.9}, {0.5, 0, 0.5}, 60.0}};
  const Image image = device_picture(mesh, units_over({0, 0, 0}, 1), picture);
  int best = -1, best_x = 0, best_y = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      if (pixel_of(image, x, y)[0] > best) {
        best = pixel_of(image, x, y)[0];
        best_x = x;
        best_y = y;
      }
    }
  }
  // The mirror point is (0.5, 0, 0.5), the middle of the picture; E falls off towards it from the lamp's
  // side.
  EXPECT_NEAR(best_x, 80, 2);
  EXPECT_NEAR(best_y, 60, 5);
  EXPECT_GT(best, pixel_of(image, 20, 100)[0] + 30);
}

}  // namespace
}  // namespace fixrad::host::testing

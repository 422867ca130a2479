// SPDX-License-Identifier: MIT
#include "host_sim/report/mirrors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/report/tone.h"
#include "lib/picture/projection.h"
#include "tests/picture/device_mesh.h"

namespace fixrad::host::testing {
namespace {

// A mirror of the unit square at z = 0, and a small patch of light that looks at it from (0.7, 0.6, 0.5).
BakedMesh mirror_and_patch(const glm::dvec3& own_light) {
  BakedMesh mesh;
  add_quad(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, own_light);
  add_quad(mesh, {0.67, 0.57, 0.5}, {0, 0.06, 0}, {0.06, 0, 0}, {0.2, 0.4, 0.1});
  mesh.appearances = {{{0.5, 0.5, 0.5}, 0, true}, {}};
  mesh.triangle_appearance = {0, 0, 1, 1};
  return mesh;
}

PictureOptions from_the_side() {
  return {160, 120, Camera{{0.2, 0.5, 0.9}, {0.5, 0.5, 0}, 70.0}};
}

TEST(DeviceRenderer, ShowsAPatchInTheMirrorWhereItsReflectionProjects) {
  const BakedMesh mesh = mirror_and_patch({0.02, 0.02, 0.02});
  const Image image = device_picture(mesh, units_over({0, 0, 0}, 1), from_the_side());
  const Projection projection(*from_the_side().camera, false, 160, 120);
  const glm::dvec2 expected = projection.to_pixels(projection.to_camera({0.7, 0.6, -0.5}));
  double weight = 0;
  glm::dvec2 middle(0.0);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const std::array<int, 3> pixel = pixel_of(image, x, y);
      if (pixel[1] > pixel[0] + 20) {  // green: the patch's front can be seen in the mirror only
        weight += 1;
        middle += glm::dvec2(x + 0.5, y + 0.5);
      }
    }
  }
  ASSERT_GT(weight, 5);
  EXPECT_NEAR(middle.x / weight, expected.x, 0.6);
  EXPECT_NEAR(middle.y / weight, expected.y, 0.6);
}

TEST(DeviceRenderer, AddsKsTimesTheReflectionToTheMirrorsOwnLight) {
  const BakedMesh mesh = mirror_and_patch({0.02, 0.02, 0.02});
  const Image image = device_picture(mesh, units_over({0, 0, 0}, 1), from_the_side());
  const Projection projection(*from_the_side().camera, false, 160, 120);
  const glm::dvec2 at = projection.to_pixels(projection.to_camera({0.7, 0.6, -0.5}));
  const double scale = exposure_scale(mesh, {});
  const std::array<int, 3> pixel = pixel_of(image, static_cast<int>(at.x), static_cast<int>(at.y));
  const Srgb8 expected = display_colour(glm::dvec3(0.02) + 0.5 * glm::dvec3(0.2, 0.4, 0.1), scale);
  const std::array<int, 3> elsewhere = pixel_of(image, 60, 90);
  const Srgb8 empty = display_colour(glm::dvec3(0.02) + 0.5 * glm::dvec3(kBackground / scale), scale);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(pixel[c], expected[c], 1);
    EXPECT_NEAR(elsewhere[c], empty[c], 1);
  }
}

TEST(DeviceRenderer, LeavesWhatStandsBehindAMirrorOutOfItsImage) {
  BakedMesh mesh = mirror_and_patch({0.02, 0.02, 0.02});
  const Image before = device_picture(mesh, units_over({0, 0, 0}, 1), from_the_side());
  // A bright wall behind the mirror that looks the same way.
  BakedMesh behind = mesh;
  add_quad(behind, {0.1, 0.1, -0.2}, {0.8, 0, 0}, {0, 0.8, 0}, {0.03, 0.03, 0.03});
  behind.triangle_appearance.insert(behind.triangle_appearance.end(), {1, 1});
  Display display;
  display.exposure_ev = std::log2(exposure_scale(mesh, {}) / exposure_scale(behind, {}));
  const DeviceUnits units = units_over({-0.1, -0.1, -0.3}, 1.5);
  const PictureTable table = make_picture_table(behind, units, display, from_the_side());
  const Image after = draw_on_device(table, exposed_light(behind, units, table));
  const Projection projection(*from_the_side().camera, false, 160, 120);
  for (const glm::dvec3 point : {glm::dvec3(0.3, 0.3, 0), {0.5, 0.5, 0}, {0.8, 0.8, 0}}) {
    const glm::dvec2 at = projection.to_pixels(projection.to_camera(point));
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    EXPECT_NEAR(pixel_of(after, x, y)[0], pixel_of(before, x, y)[0], 1);
  }
}

TEST(DeviceRenderer, GivesTheSameMirrorForEveryBand) {
  const BakedMesh mesh = mirror_and_patch({0.1, 0.1, 0.1});
  const DeviceUnits units = units_over({0, 0, 0}, 1);
  const Image whole = device_picture(mesh, units, from_the_side(), 120);
  EXPECT_EQ(device_picture(mesh, units, from_the_side(), 1).rgb, whole.rgb);
  EXPECT_EQ(device_picture(mesh, units, from_the_side(), 50).rgb, whole.rgb);
}

TEST(MirroredCamera, SeesAPointWhereTheCameraSeesItsImage) {
  const BakedMesh mesh = mirror_and_patch({0.1, 0.1, 0.1});
  const PictureTable table = make_picture_table(mesh, units_over({0, 0, 0}, 1), {}, from_the_side());
  const fixrad::Projection camera = projection_of(table.camera);
  fixrad::Projection image;
  ASSERT_TRUE(mirrored(camera, table.mirrors[0], image));
  EXPECT_TRUE(image.is_mirrored);
  const std::int32_t plane = 2 * 8;  // the mirror lies at z = 8
  for (const Vec3 point : {Vec3{100, 200, 3000}, {9000, 4000, 100}, {16000, 16000, 9000}}) {
    const Vec3 seen = to_view(image, point), expected = to_view(camera, {point.x, point.y, plane - point.z});
    EXPECT_NEAR(seen.x, expected.x, 16);
    EXPECT_NEAR(seen.y, expected.y, 16);
    EXPECT_NEAR(seen.z, expected.z, 16);
  }
}

TEST(Mirrors, AreGroupedByPlaneAndMaterial) {
  BakedMesh mesh = mirror_and_patch({0.1, 0.1, 0.1});
  add_quad(mesh, {0, 0, 2}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1});
  mesh.triangle_appearance.insert(mesh.triangle_appearance.end(), {0, 0});
  const Mirrors mirrors = find_mirrors(mesh);
  ASSERT_EQ(mirrors.planes.size(), 2u);
  EXPECT_EQ(mirrors.of_triangle, (std::vector<std::uint32_t>{0, 0, Mirrors::kNone, Mirrors::kNone, 1, 1}));
  EXPECT_EQ(reflected(mirrors.planes[1], {0.5, 0.5, 1.5}), glm::dvec3(0.5, 0.5, 2.5));
}

}  // namespace
}  // namespace fixrad::host::testing

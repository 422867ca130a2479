// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>

#include "host_sim/report/rasterizer.h"
#include "host_sim/report/tone.h"
#include "tests/picture/device_mesh.h"

namespace fixrad::host::testing {
namespace {

constexpr int kWidth = 160, kHeight = 120;

PictureOptions into_the_room() {
  return {kWidth, kHeight, Camera{{0.45, 0.6, -1.4}, {0.5, 0.45, 0.5}, 45.0}};
}

// The room with a different radiosity at every corner.
BakedMesh shaded_room() {
  BakedMesh mesh = open_room();
  for (std::size_t v = 0; v < mesh.radiosity.size(); ++v) {
    mesh.radiosity[v] *= 0.3 + 0.2 * static_cast<double>(v % 4);
  }
  return mesh;
}

// One sample a pixel of the renderer in double, displayed as the core displays it.
Image double_picture(const BakedMesh& mesh, const PictureOptions& picture) {
  const Projection projection(*picture.camera, false, picture.width, picture.height);
  SampleBand band;
  band.clear(picture.width, 0, picture.height);
  for (const ScreenTriangle& triangle : visible_triangles(mesh, projection, 1e-5)) {
    draw(triangle, band);
  }
  Image image{picture.width, picture.height, {}};
  for (std::size_t i = 0; i < band.radiosity.size(); ++i) {
    const Srgb8 colour = band.inverse_distance[i] > 0
                             ? display_colour(band.radiosity[i], exposure_scale(mesh, {}))
                             : srgb8(glm::dvec3(kBackground));
    image.rgb.insert(image.rgb.end(), colour.begin(), colour.end());
  }
  return image;
}

TEST(DeviceRenderer, DrawsThePictureOfTheRendererInDouble) {
  const BakedMesh mesh = shaded_room();
  const Image device = device_picture(mesh, units_over({0, 0, 0}, 1), into_the_room());
  const Image exact = double_picture(mesh, into_the_room());
  ASSERT_EQ(device.rgb.size(), exact.rgb.size());
  double sum = 0;
  int apart = 0;
  for (std::size_t i = 0; i < exact.rgb.size(); ++i) {
    const int difference = std::abs(device.rgb[i] - exact.rgb[i]);
    sum += difference;
    apart += difference > 2 ? 1 : 0;  // a pixel whose centre lies on an edge may change hands
  }
  EXPECT_LE(sum / static_cast<double>(exact.rgb.size()), 0.3) << "codes of 255, mean";
  EXPECT_LE(apart / static_cast<double>(exact.rgb.size()), 0.003);
}

TEST(DeviceRenderer, ComesNearTheAntiAliasedPictureToo) {
  const BakedMesh mesh = shaded_room();
  const Image device = device_picture(mesh, units_over({0, 0, 0}, 1), into_the_room());
  const Image smooth = render_picture(mesh, {}, into_the_room());
  double sum = 0;
  for (std::size_t i = 0; i < smooth.rgb.size(); ++i) {
    sum += std::abs(device.rgb[i] - smooth.rgb[i]);
  }
  EXPECT_LE(sum / static_cast<double>(smooth.rgb.size()), 1.0) << "codes of 255, mean";
}

TEST(DeviceRenderer, GivesTheSamePixelsForEveryBand) {
  const BakedMesh mesh = shaded_room();
  const DeviceUnits units = units_over({0, 0, 0}, 1);
  const Image whole = device_picture(mesh, units, into_the_room(), kHeight);
  for (const int rows : {1, 7, 119}) {
    EXPECT_EQ(device_picture(mesh, units, into_the_room(), rows).rgb, whole.rgb) << rows;
  }
}

TEST(DeviceRenderer, DrawsAGreySceneInOneChannelAsInThree) {
  BakedMesh mesh = shaded_room();
  for (glm::dvec3& radiosity : mesh.radiosity) {
    radiosity = glm::dvec3(radiosity.x);
  }
  DeviceUnits units = units_over({0, 0, 0}, 1);
  const Image colour = device_picture(mesh, units, into_the_room());
  units.channels = 1;
  EXPECT_EQ(device_picture(mesh, units, into_the_room()).rgb, colour.rgb);
}

TEST(DeviceRenderer, ShowsTheNearerOfTwoSurfacesInEitherOrder) {
  for (const bool near_first : {true, false}) {
    BakedMesh mesh;
    const glm::dvec3 near_colour(0.1, 0.4, 0.1), far_colour(0.4, 0.1, 0.1);
    add_quad(mesh, {0, 0, near_first ? 0.6 : 0.4}, {1, 0, 0}, {0, 1, 0},
             near_first ? near_colour : far_colour);
    add_quad(mesh, {0, 0, near_first ? 0.4 : 0.6}, {1, 0, 0}, {0, 1, 0},
             near_first ? far_colour : near_colour);
    const Image image =
        device_picture(mesh, units_over({0, 0, 0}, 1), {64, 64, Camera{{0.5, 0.5, 2}, {0.5, 0.5, 0}, 40.0}});
    const std::array<int, 3> middle = pixel_of(image, 32, 32);
    EXPECT_GT(middle[1], middle[0]);
  }
}

TEST(DeviceRenderer, HidesBackFacesAndKeepsFloorsThatRunBehindTheEye) {
  BakedMesh mesh;
  add_quad(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 1});
  const Srgb8 background = srgb8(glm::dvec3(kBackground));
  const Image above =
      device_picture(mesh, units_over({0, 0, 0}, 1), {64, 64, Camera{{0.5, 0.1, 0.5}, {0.5, 0.1, 0}, 90.0}});
  EXPECT_EQ(pixel_of(above, 32, 10)[0], background[0]);
  EXPECT_EQ(pixel_of(above, 32, 55)[0], display_colour({1, 1, 1}, exposure_scale(mesh, {}))[0]);
  const Image below = device_picture(mesh, units_over({0, 0, 0}, 1),
                                     {64, 64, Camera{{0.5, -0.1, 0.5}, {0.5, -0.1, 0}, 90.0}});
  for (const std::uint8_t code : below.rgb) {
    ASSERT_EQ(code, background[0]);
  }
}

TEST(DeviceRenderer, RefusesTablesAndCamerasOutOfRange) {
  const BakedMesh mesh = shaded_room();
  PictureTable table = make_picture_table(mesh, units_over({0, 0, 0}, 1), {}, into_the_room());
  const PictureBand band = {nullptr, nullptr, 1};
  const PictureBand no_band = {nullptr, nullptr, 0};
  EXPECT_EQ(check_picture(table.view(), table.camera, band), PictureStatus::ok);
  EXPECT_EQ(check_picture(table.view(), table.camera, no_band), PictureStatus::no_memory);
  PictureScene scene = table.view();
  scene.channels = 2;
  EXPECT_EQ(check_picture(scene, table.camera, band), PictureStatus::bad_channel_count);
  PictureCamera camera = table.camera;
  camera.eye[1] = kCameraHigh + 1;
  EXPECT_EQ(check_picture(table.view(), camera, band), PictureStatus::bad_camera);
  camera = table.camera;
  camera.width = 0;
  EXPECT_EQ(check_picture(table.view(), camera, band), PictureStatus::bad_camera);
  table.triangles[1].corner[2] = static_cast<std::uint16_t>(table.vertices.size());
  EXPECT_EQ(check_picture(table.view(), table.camera, band), PictureStatus::bad_index);
  PictureOptions far = into_the_room();
  far.camera->eye.z = -10;
  EXPECT_THROW(make_picture_table(mesh, units_over({0, 0, 0}, 1), {}, far), std::runtime_error);
}

}  // namespace
}  // namespace fixrad::host::testing

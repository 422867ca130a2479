// SPDX-License-Identifier: MIT
#include "host_sim/report/picture.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "host_sim/report/rasterizer.h"
#include "host_sim/report/tone.h"
#include "tests/report/sample_mesh.h"

namespace fixrad::host {
namespace {

constexpr int kSide = 64;

Srgb8 pixel(const Image& image, int x, int y) {
  const auto at = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

/// Looks along -z from z = 5, so that a unit in the plane z = 0 is 12.8 of the 64 pixels.
PictureOptions from_front() {
  return {kSide, kSide, Camera{{0, 0, 5}, {0, 0, 0}, 53.13010235415598}};
}

/// A colour that no surface has in these tests: the corner of a picture of a small square.
Srgb8 background() {
  return pixel(render_picture(testing::square({1, 1, 1}), {}, from_front()), 0, 0);
}

TEST(Picture, ShowsAUniformSquareInTheToneOfItsRadiosity) {
  const glm::dvec3 radiosity(0.9, 0.5, 0.2);
  const BakedMesh mesh = testing::square(radiosity);
  const Image image = render_picture(mesh, {}, from_front());
  const Srgb8 expected = display_colour(radiosity, exposure_scale(mesh, {}));
  for (const int at : {22, 32, 41}) {
    EXPECT_EQ(pixel(image, at, at), expected);
    EXPECT_EQ(pixel(image, at, 63 - at), expected);
  }
}

TEST(Picture, EndsTheSquareWhereItsCornersProject) {
  // The square spans 32 +- 12.8 pixels: pixel 19 is covered for 0.8 of its width, pixel 18 not at all.
  const Image image = render_picture(testing::square({1, 1, 1}), {}, from_front());
  EXPECT_EQ(pixel(image, 18, 32), background());
  EXPECT_GT(pixel(image, 19, 32)[0], background()[0]);
  EXPECT_LT(pixel(image, 19, 32)[0], pixel(image, 20, 32)[0]);
  EXPECT_EQ(pixel(image, 20, 32), pixel(image, 32, 32));
}

TEST(Picture, HidesBackFaces) {
  PictureOptions from_behind = from_front();
  from_behind.camera->eye.z = -5.0;
  const Image image = render_picture(testing::square({1, 1, 1}), {}, from_behind);
  EXPECT_EQ(pixel(image, 32, 32), background());
}

TEST(Picture, ShowsTheNearerOfTwoSurfacesInEitherOrder) {
  const glm::dvec3 near_colour(0.2, 0.8, 0.2);
  const glm::dvec3 far_colour(0.8, 0.2, 0.2);
  for (const bool near_first : {true, false}) {
    BakedMesh mesh;
    testing::add_quad(mesh, {-1, -1, near_first ? 1.0 : 0.0}, {2, 0, 0}, {0, 2, 0},
                      near_first ? near_colour : far_colour);
    testing::add_quad(mesh, {-1, -1, near_first ? 0.0 : 1.0}, {2, 0, 0}, {0, 2, 0},
                      near_first ? far_colour : near_colour);
    const Image image = render_picture(mesh, {}, from_front());
    EXPECT_EQ(pixel(image, 32, 32), display_colour(near_colour, exposure_scale(mesh, {})));
  }
}

TEST(Picture, ShowsTheOpenRoomWithRedOnTheLeftAndGreenOnTheRight) {
  const Image image = render_picture(testing::open_room(), {}, {kSide, kSide, {}});
  const Srgb8 left = pixel(image, 6, 32);
  const Srgb8 right = pixel(image, 57, 32);
  EXPECT_GT(left[0], 2 * left[1]);
  EXPECT_GT(right[1], right[0] + 50);
  EXPECT_EQ(pixel(image, 32, 6), (Srgb8{255, 255, 255})) << "the ceiling is a lamp";
}

TEST(Picture, LooksTheSameForZUpAfterAQuarterTurn) {
  const BakedMesh y_up = testing::open_room();
  BakedMesh z_up = y_up;
  for (glm::dvec3& p : z_up.positions) {
    p = {p.x, -p.z, p.y};
  }
  Display display;
  display.z_up = true;
  const PictureOptions options{kSide, 48, {}};
  EXPECT_EQ(render_picture(y_up, {}, options).rgb, render_picture(z_up, display, options).rgb);
}

TEST(Picture, KeepsSurfacesThatRunBehindTheEye) {
  // A floor from far in front to far behind the eye: the lower half of the picture shows it, the upper one
  // not.
  BakedMesh mesh;
  testing::add_quad(mesh, {-100, -1, -100}, {0, 0, 200}, {200, 0, 0}, {1, 1, 1});
  const Image image = render_picture(mesh, {}, {kSide, kSide, Camera{{0, 0, 0}, {0, 0, -1}, 90.0}});
  EXPECT_EQ(pixel(image, 32, 60), display_colour({1, 1, 1}, exposure_scale(mesh, {})));
  EXPECT_EQ(pixel(image, 32, 30), background());
}

TEST(Picture, LeavesNoGapBetweenTheTrianglesOfASurface) {
  BakedMesh mesh;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      testing::add_quad(mesh, {-2.0 + 4.0 * i / 7, -2.0 + 4.0 * j / 7, 0}, {4.0 / 7, 0, 0}, {0, 4.0 / 7, 0},
                        {1, 1, 1});
    }
  }
  const Image image = render_picture(mesh, {}, from_front());
  for (int y = 8; y < 56; ++y) {
    for (int x = 8; x < 56; ++x) {
      ASSERT_EQ(pixel(image, x, y), pixel(image, 32, 32)) << x << ' ' << y;
    }
  }
}

TEST(Picture, RefusesSizesOutOfRange) {
  EXPECT_THROW(render_picture(testing::square({1, 1, 1}), {}, {0, 10, {}}), std::invalid_argument);
  EXPECT_THROW(render_picture(testing::square({1, 1, 1}), {}, {10, 20000, {}}), std::invalid_argument);
}

/// One triangle drawn into a band of one sample, whose centre is (0.5, 0.5).
glm::dvec3 sample_of(const std::array<glm::dvec3, 3>& camera_vertices,
                     const std::array<glm::dvec3, 3>& radiosity) {
  ScreenTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    const double inverse = 1.0 / camera_vertices[i].z;
    triangle[i] = {{camera_vertices[i].x * inverse + 0.5, camera_vertices[i].y * inverse + 0.5},
                   inverse,
                   radiosity[i] * inverse};
  }
  SampleBand band;
  band.clear(1, 0, 1);
  draw(triangle, band);
  EXPECT_GT(band.inverse_distance[0], 0.0);
  return band.radiosity[0];
}

TEST(Rasterizer, GivesTheMeanOfTheCornersAtATrianglesCentre) {
  const glm::dvec3 centre =
      sample_of({{{2, 0, 1}, {-1, 1, 1}, {-1, -1, 1}}}, {{{3, 0, 0}, {0, 6, 0}, {0, 0, 9}}});
  EXPECT_NEAR(centre.x, 1.0, 1e-12);
  EXPECT_NEAR(centre.y, 2.0, 1e-12);
  EXPECT_NEAR(centre.z, 3.0, 1e-12);
}

TEST(Rasterizer, InterpolatesInSpaceAndNotInThePicture) {
  // The ray through the sample meets the triangle at its centroid (0, 0, 2): corners at distances 1, 2 and 3.
  const glm::dvec3 centre =
      sample_of({{{1, 1, 1}, {1, -3, 2}, {-2, 2, 3}}}, {{{3, 0, 0}, {0, 6, 0}, {0, 0, 9}}});
  EXPECT_NEAR(centre.x, 1.0, 1e-12);
  EXPECT_NEAR(centre.y, 2.0, 1e-12);
  EXPECT_NEAR(centre.z, 3.0, 1e-12);
}

}  // namespace
}  // namespace fixrad::host

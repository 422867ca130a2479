// SPDX-License-Identifier: MIT
// Highlights and mirrors in the pictures of the renderer in double, and both renderers against each other.
#include <gtest/gtest.h>

#include <cstdlib>

#include "host_sim/report/mirrors.h"
#include "host_sim/report/tone.h"
#include "tests/picture/device_mesh.h"

namespace fixrad::host::testing {
namespace {

// A room whose floor is shiny and whose far wall is a mirror; the lamp fills the ceiling's middle.
BakedMesh shiny_room() {
  BakedMesh mesh;
  add_quad(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0.2, 0.15, 0.1});
  add_quad(mesh, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0.5, 0.5, 0.5});
  add_quad(mesh, {1, 0, 1}, {-1, 0, 0}, {0, 1, 0}, {0.05, 0.05, 0.05});
  add_quad(mesh, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0.6, 0.05, 0.05});
  add_quad(mesh, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.4, 0.08});
  mesh.appearances = {{}, {{0.3, 0.3, 0.3}, 50, false}, {{0.8, 0.8, 0.7}, 0, true}};
  mesh.triangle_appearance = {1, 1, 0, 0, 2, 2, 0, 0, 0, 0};
  mesh.lamps = {{{0.5, 0.98, 0.6}, {0, -1, 0}, 0.02, {30, 28, 25}}};
  return mesh;
}

PictureOptions into_the_room() {
  return {160, 120, Camera{{0.45, 0.6, -0.9}, {0.5, 0.4, 0.5}, 50.0}};
}

TEST(ViewDependentPicture, ShowsAPatchInTheMirrorWithKsOfItsLight) {
  const BakedMesh mesh = shiny_room();
  const Image image = render_picture(mesh, {}, into_the_room());
  const Projection projection(*into_the_room().camera, false, 160, 120);
  // A point of the red wall at z = 0.5 appears in the mirror at z = 1 as if it were at z = 1.5.
  const glm::dvec2 at = projection.to_pixels(projection.to_camera({1, 0.5, 1.5}));
  const Srgb8 expected = display_colour(
      glm::dvec3(0.05) + glm::dvec3(0.8, 0.8, 0.7) * glm::dvec3(0.6, 0.05, 0.05), exposure_scale(mesh, {}));
  const std::array<int, 3> pixel = pixel_of(image, static_cast<int>(at.x) - 2, static_cast<int>(at.y));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(pixel[c], expected[c], 1);
  }
}

TEST(ViewDependentPicture, AddsThePhongTermAtEachPoint) {
  const BakedMesh mesh = shiny_room();
  const Image image = render_picture(mesh, {}, into_the_room());
  const Projection projection(*into_the_room().camera, false, 160, 120);
  for (const glm::dvec3 point : {glm::dvec3(0.5, 0, 0.2), {0.3, 0, 0.4}, {0.6, 0, 0.1}}) {
    const glm::dvec3 shine =
        highlights(mesh.lamps, mesh.appearances[1], point, {0, 1, 0}, into_the_room().camera->eye);
    const Srgb8 expected = display_colour(glm::dvec3(0.2, 0.15, 0.1) + shine, exposure_scale(mesh, {}));
    const glm::dvec2 at = projection.to_pixels(projection.to_camera(point));
    const std::array<int, 3> pixel = pixel_of(image, static_cast<int>(at.x), static_cast<int>(at.y));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(pixel[c], expected[c], 6) << point.x << ": half a pixel away at most";
    }
  }
}

TEST(ViewDependentPicture, IsTheOneThatTheDeviceDraws) {
  const BakedMesh mesh = shiny_room();
  const Image exact = render_picture(mesh, {}, into_the_room());
  const Image device = device_picture(mesh, units_over({0, 0, 0}, 1), into_the_room());
  double sum = 0;
  for (std::size_t i = 0; i < exact.rgb.size(); ++i) {
    sum += std::abs(device.rgb[i] - exact.rgb[i]);
  }
  EXPECT_LE(sum / static_cast<double>(exact.rgb.size()), 1.0) << "codes of 255, mean";
}

TEST(ViewDependentPicture, ChangesNothingWhereAllIsMatt) {
  BakedMesh mesh = shiny_room();
  mesh.appearances = {{}, {}, {}};
  const Image with = render_picture(mesh, {}, into_the_room());
  mesh.appearances.clear();
  mesh.triangle_appearance.clear();
  EXPECT_EQ(render_picture(mesh, {}, into_the_room()).rgb, with.rgb);
}

}  // namespace
}  // namespace fixrad::host::testing

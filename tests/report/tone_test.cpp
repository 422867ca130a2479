// SPDX-License-Identifier: MIT
#include "host_sim/report/tone.h"

#include <gtest/gtest.h>

#include "tests/report/sample_mesh.h"

namespace fixrad::host {
namespace {

/// Rounding of double in a handful of operations.
constexpr double kRounding = 1e-12;

TEST(Srgb, HasTheValuesOfTheStandard) {
  EXPECT_EQ(srgb_from_linear(0.0), 0.0);
  EXPECT_NEAR(srgb_from_linear(1.0), 1.0, kRounding);
  EXPECT_NEAR(srgb_from_linear(0.001), 0.01292, kRounding);
  // Middle grey: an encoded 0.5 is ((0.5 + 0.055) / 1.055)^2.4 linear.
  EXPECT_NEAR(srgb_from_linear(0.21404114048223255), 0.5, 1e-9);
}

TEST(Srgb, RoundsToNearestAndClamps) {
  EXPECT_EQ(srgb8({0.21404114048223255, 0.0, 2.0}), (Srgb8{128, 0, 255}));
}

TEST(ToneCurve, IsTheIdentityBelowTheShoulder) {
  for (const double x : {0.0, 0.01, 0.2, kShoulderStart}) {
    EXPECT_EQ(tone_curve(x), x);
  }
}

TEST(ToneCurve, ReachesOneAtTheWhitePointAndStaysThere) {
  EXPECT_NEAR(tone_curve(kWhitePoint * (1.0 - 1e-12)), 1.0, 1e-9);
  EXPECT_EQ(tone_curve(kWhitePoint), 1.0);
  EXPECT_EQ(tone_curve(1e9), 1.0);
}

TEST(ToneCurve, RisesEverywhereAndHasNoKinkAtTheShoulder) {
  for (double x = 0.0; x < kWhitePoint - 0.01; x += 0.01) {
    EXPECT_LT(tone_curve(x), tone_curve(x + 0.01));
  }
  const double h = 1e-6;
  EXPECT_NEAR((tone_curve(kShoulderStart + h) - tone_curve(kShoulderStart)) / h, 1.0, 1e-4);
}

TEST(Tone, KeepsGreyGrey) {
  for (const double x : {0.0, 0.1, 0.9, 5.0, 100.0}) {
    const glm::dvec3 colour = tone(glm::dvec3(x));
    EXPECT_NEAR(colour.x, tone_curve(x), kRounding);
    EXPECT_EQ(colour.x, colour.y);
    EXPECT_EQ(colour.y, colour.z);
  }
}

TEST(Tone, KeepsTheRatiosOfChannelsBelowTheShoulder) {
  const glm::dvec3 exposed(0.4, 0.2, 0.1);
  const glm::dvec3 colour = tone(exposed);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(colour[k], exposed[k], kRounding);
  }
}

TEST(Tone, ShowsALampAsWhiteWhateverItsColour) {
  const glm::dvec3 colour = tone({53.0, 38.0, 13.0});
  EXPECT_EQ(srgb8(colour), (Srgb8{255, 255, 255}));
}

TEST(Exposure, BringsAUniformSceneToTheMiddleLuminance) {
  const BakedMesh mesh = testing::square({3.0, 3.0, 3.0});
  EXPECT_NEAR(3.0 * exposure_scale(mesh, {}), kMiddleLuminance, kRounding);
}

TEST(Exposure, DoublesWithEachStop) {
  const BakedMesh mesh = testing::square({3.0, 2.0, 1.0});
  Display brighter;
  brighter.exposure_ev = 1.0;
  EXPECT_NEAR(exposure_scale(mesh, brighter), 2.0 * exposure_scale(mesh, {}), kRounding);
}

TEST(Exposure, FollowsTheUnitOfRadiosity) {
  BakedMesh mesh = testing::open_room();
  const double scale = exposure_scale(mesh, {});
  for (BakedElement& element : mesh.elements) {
    element.radiosity *= 1000.0;
  }
  EXPECT_NEAR(1000.0 * exposure_scale(mesh, {}), scale, 1e-9 * scale);
}

TEST(Exposure, IsNotDrivenByLamps) {
  BakedMesh mesh = testing::open_room();
  const double scale = exposure_scale(mesh, {});
  mesh.elements[1].radiosity *= 1e6;
  EXPECT_EQ(exposure_scale(mesh, {}), scale);
}

TEST(Exposure, IsNotDrivenByASmallHotSpot) {
  BakedMesh mesh = testing::square({1.0, 1.0, 1.0});
  testing::add_quad(mesh, {0, 0, 1}, {0.5, 0, 0}, {0, 0.5, 0}, {1e4, 1e4, 1e4});
  EXPECT_NEAR(exposure_scale(mesh, {}), kMiddleLuminance, kRounding);
}

TEST(Exposure, TakesTrianglesWhereThereAreNoElements) {
  BakedMesh mesh = testing::square({3.0, 3.0, 3.0});
  mesh.elements.clear();
  EXPECT_NEAR(3.0 * exposure_scale(mesh, {}), kMiddleLuminance, kRounding);
}

TEST(Exposure, OfASceneWithoutLightIsTheUsersCorrectionAlone) {
  Display display;
  display.exposure_ev = -2.0;
  EXPECT_EQ(exposure_scale(testing::square({0.0, 0.0, 0.0}), display), 0.25);
}

}  // namespace
}  // namespace fixrad::host

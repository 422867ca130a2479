// SPDX-License-Identifier: MIT
#include "host_sim/meshing/cell_cuts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/meshing/device_scene.h"
#include "lib/scene/scene.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

struct Square {
  Model model = cube(0.5, {0, 0, 0, 1, 0, 0});
  PreparedScene scene = prepare(model);
  const FaceFrame& frame = scene.frames[0];
  FaceElements face = cut_face(scene.frames[0], 4, 4);
};

double total_area(const FaceElements& face) {
  double sum = 0;
  for (const CellElement& element : face.elements) {
    sum += area(element.outline);
  }
  return sum;
}

TEST(CutElement, MakesTwoOfOneOnBothSidesOfTheLine) {
  Square square;
  ASSERT_TRUE(cut_element(square.frame, square.face, 5, line_through({0.25, 0.25}, {0.5, 0.5})));
  ASSERT_EQ(square.face.elements.size(), 17u);
  const glm::dvec2 left = centroid(square.face.elements[5].outline);
  const glm::dvec2 right = centroid(square.face.elements[16].outline);
  EXPECT_GT(left.y, left.x);
  EXPECT_LT(right.y, right.x);
  EXPECT_NEAR(area(square.face.elements[5].outline), 1.0 / 32, 1e-4);
  EXPECT_NEAR(total_area(square.face), 1.0, 1e-9);
}

TEST(CutElement, RoundsTheLineToAFiveHundredthOfACellAtMost) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    Square square;
    const glm::dvec2 a(random.real(0.26, 0.49), 0.25), b(random.real(0.26, 0.49), 0.5);
    if (!cut_element(square.frame, square.face, 5, line_through(a, b))) {
      continue;
    }
    const CellCut cut = square.face.cuts.at(0);
    for (const glm::dvec2 p : {a, b}) {
      const glm::dvec2 q = p * 4.0 - glm::dvec2(1.0);
      EXPECT_LT(std::abs(cut.a * q.x + cut.b * q.y + cut.c) / std::hypot(cut.a, cut.b), 1.0 / 512);
    }
  }
}

TEST(CutElement, RefusesSliversAndLinesThatMiss) {
  Square square;
  EXPECT_FALSE(cut_element(square.frame, square.face, 5, {{1, 0}, 0.251}));
  EXPECT_FALSE(cut_element(square.frame, square.face, 5, {{1, 0}, 0.75}));
  EXPECT_FALSE(cut_element(square.frame, square.face, 5, {{0, 0}, 0.0}));
  EXPECT_EQ(square.face.elements.size(), 16u);
  EXPECT_TRUE(square.face.roots.empty());
}

TEST(CutElement, GoesNoDeeperThanTheCoreFollows) {
  Square square;
  int cuts = 0;
  const LeastPart any = {0, 0};
  for (double x = 0.375; cut_element(square.frame, square.face, 5, {{1, 0}, x}, any);
       x = 0.5 - (0.5 - x) * 0.8) {
    ++cuts;
    ASSERT_LE(cuts, kMostCuts);
  }
  EXPECT_GT(cuts, 5);
}

TEST(CutAlong, CutsWhatTheSegmentCrossesAndNothingElse) {
  Square square;
  EXPECT_EQ(cut_along(square.frame, square.face, {0.1, 0.6}, {0.7, 0.6}, 1.0), 3);
  EXPECT_EQ(square.face.elements.size(), 19u);
  EXPECT_NEAR(total_area(square.face), 1.0, 1e-9);
  EXPECT_EQ(cut_along(square.frame, square.face, {0.1, 0.6}, {0.7, 0.6}, 1.0), 0) << "they are cut already";
}

}  // namespace
}  // namespace fixrad::host

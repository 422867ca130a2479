// SPDX-License-Identifier: MIT
// The expectations of the other tests, tested themselves.
#include "tests/lib/closed_forms.h"

#include <gtest/gtest.h>

namespace fixrad::host {
namespace {

constexpr Rectangle kUnit = {0, 1, 0, 1};

TEST(ClosedForms, MatchTheTextbookFactorsOfUnitSquares) {
  EXPECT_NEAR(parallel_form_factor(kUnit, kUnit, 1.0), kParallelUnitSquares, 1e-12);
  EXPECT_NEAR(perpendicular_form_factor(kUnit, kUnit), kPerpendicularUnitSquares, 1e-12);
  EXPECT_NEAR(kParallelUnitSquares + 4 * kPerpendicularUnitSquares, 1.0, 1e-12);
}

TEST(ClosedForms, AddUpOverTheCubeForEveryElement) {
  const Rectangle element = {0.125, 0.25, 0.5, 0.625};
  const Rectangle from_right = {0.75, 0.875, 0.5, 0.625};
  const Rectangle turned = {0.5, 0.625, 0.125, 0.25};
  const Rectangle turned_back = {0.375, 0.5, 0.125, 0.25};
  const double sum = parallel_form_factor(element, kUnit, 1.0) + perpendicular_form_factor(element, kUnit) +
                     perpendicular_form_factor(from_right, kUnit) + perpendicular_form_factor(turned, kUnit) +
                     perpendicular_form_factor(turned_back, kUnit);
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(ClosedForms, PointFactorIsTheLimitOfASmallElement) {
  const Rectangle small = {0.4999, 0.5001, 0.2999, 0.3001};
  EXPECT_NEAR(parallel_form_factor(small, kUnit, 1.0), point_to_parallel({-0.5, 0.5, -0.3, 0.7}, 1.0), 1e-6);
}

TEST(ClosedForms, CubeConservesEnergy) {
  // Absorbed (1 - rho) / rho * (B - E) over all faces is what is emitted: 1.
  const double rho = 0.7;
  const std::array<double, 3> coarse = cube_radiosity(rho, kParallelUnitSquares, kPerpendicularUnitSquares);
  const std::array<double, 3> fine = RefinedCube(6).face_means(rho);
  EXPECT_NEAR((1 - rho) / rho * (coarse[0] - 1 + coarse[1] + 4 * coarse[2]), 1.0, 1e-9);
  EXPECT_NEAR((1 - rho) / rho * (fine[0] - 1 + fine[1] + 4 * fine[2]), 1.0, 1e-6);
}

TEST(ClosedForms, RefinedCubeIsRefinedEnough) {
  constexpr double kStillMoves = 0.002;  // from 8 to 12 elements along an edge
  const std::array<double, 3> coarse = RefinedCube(8).face_means(0.5);
  const std::array<double, 3> fine = RefinedCube(12).face_means(0.5);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(coarse[i] / fine[i], 1.0, kStillMoves);
  }
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// The unit cube with one emitting face.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/lib/closed_forms.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr std::array<double, 6> kFloorEmits = {0, 0, 1, 0, 0, 0};
constexpr double kReflectances[] = {0.1, 0.3, 0.5, 0.7, 0.9, 0.99};

// Of the six faces -x +x -y +y -z +z: the emitter (-y), the opposite one and the worst side.
double worst_face(const std::vector<double>& means, const std::array<double, 3>& expected) {
  double worst = std::max(std::abs(means[2] / expected[0] - 1), std::abs(means[3] / expected[1] - 1));
  for (const std::size_t side : {0u, 1u, 4u, 5u}) {
    worst = std::max(worst, std::abs(means[side] / expected[2] - 1));
  }
  return worst;
}

double solve_and_compare(double reflectance, const SolveOptions& options,
                         const std::array<double, 3>& expected) {
  Solution solution(cube(reflectance, kFloorEmits), options);
  EXPECT_EQ(solution.run(), Status::converged);
  return worst_face(solution.face_means(), expected);
}

// Moves every eye to the centre of its face.
Status look_from_the_centre(const Scene& scene, const DeltaTable& table, const EyeSample& sample,
                            Workspace& work, FormFactorRow& row) {
  EyeSample centred = sample;
  centred.eye.position = element_eye(scene, sample.eye.face).position;
  return hemicube_rows(scene, table, centred, work, row);
}

TEST(Cube, OneElementAFaceHasTheExactSixBySixAnswerOfCentreFactors) {
  constexpr double kBound = 0.003;
  const double opposite = point_to_parallel({-0.5, 0.5, -0.5, 0.5}, 1.0);
  SolveOptions options;
  options.elements = 6;
  options.settings = settings_with(64, fraction(1, 100000));
  options.settings.engine = look_from_the_centre;
  for (const double reflectance : kReflectances) {
    const double worst =
        solve_and_compare(reflectance, options, cube_radiosity(reflectance, opposite, (1 - opposite) / 4));
    RecordProperty("worst_percent_at_" + std::to_string(reflectance), std::to_string(100 * worst));
    EXPECT_LT(worst, kBound) << reflectance;
  }
}

// Nine eyes a face are a 3 x 3 midpoint rule for the average over its area.
TEST(Cube, NineEyesAFaceComeNearTheAreaAveragedSixBySixAnswer) {
  constexpr double kBound = 0.02;
  SolveOptions options;
  options.elements = 6;
  options.settings = settings_with(32, fraction(1, 100000));
  options.settings.flux_per_eye = Fraction::from_raw(0);  // always the most eyes
  options.settings.flux_per_row = Fraction::from_raw(0);  // and never from a patch or face
  for (const double reflectance : kReflectances) {
    const double worst = solve_and_compare(
        reflectance, options, cube_radiosity(reflectance, kParallelUnitSquares, kPerpendicularUnitSquares));
    RecordProperty("worst_percent_at_" + std::to_string(reflectance), std::to_string(100 * worst));
    EXPECT_LT(worst, kBound) << reflectance;
  }
}

TEST(Cube, RefinedMeshReachesTheRefinedSolutionInDouble) {
  constexpr double kBar = 0.015;
  static const RefinedCube reference(12);
  SolveOptions options;
  options.elements = 600;
  options.settings = settings_with(32, fraction(1, 1000));
  options.settings.flux_per_row = fraction(1, 6000);  // 0.1 / elements, as the tool sets it
  for (const double reflectance : kReflectances) {
    const double worst = solve_and_compare(reflectance, options, reference.face_means(reflectance));
    RecordProperty("worst_percent_at_" + std::to_string(reflectance), std::to_string(100 * worst));
    EXPECT_LT(worst, kBar) << reflectance;
  }
}

}  // namespace
}  // namespace fixrad::host

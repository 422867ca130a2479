// SPDX-License-Identifier: MIT
// Form factors of squares from the engines, and two squares that light each other.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/lib/closed_forms.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr int kResolutions[] = {8, 16, 32, 64, 128};

struct SquareFactor {
  double mean;  // over the elements of face 0
  double rms;   // of an eye's factor against its closed form
};

double exact_from(const glm::dvec3& p, bool is_parallel) {
  if (is_parallel) {
    return point_to_parallel({-p.x, 1 - p.x, -p.z, 1 - p.z}, 1.0);
  }
  // To a perpendicular square that stands on the line x = 0: a very thin strip is as good as a point.
  const double thin = 1e-4;
  return perpendicular_form_factor({p.x - thin, p.x + thin, p.z - thin, p.z + thin}, {0, 1, 0, 1});
}

SquareFactor measure(bool is_parallel, Engine engine, int resolution) {
  SolveOptions options;
  options.elements = 200;
  options.settings = settings_with(resolution, fraction(1, 1000));
  options.settings.engine = engine;
  Solution solution(is_parallel ? parallel_squares(0, 1, 0) : perpendicular_squares(0, 1, 0), options);
  State& state = solution.state();
  SquareFactor result = {0, 0};
  int count = 0;
  for (unsigned e = 0; e < state.scene.element_count; ++e) {
    const Element element = flash_read(state.scene.elements, e);
    if (element.face != 0) {
      continue;
    }
    clear(state.row);
    const EyeSample sample = {element_eye(state.scene, e, static_cast<std::uint8_t>(e)), kRowOne, true};
    EXPECT_EQ(engine(state.scene, *options.settings.tables, sample, state.work, state.row), Status::ok);
    std::uint32_t sum = 0;
    for (unsigned j = 0; j < state.scene.element_count; ++j) {
      sum += flash_read(state.scene.elements, j).face == 1 ? state.row.share[j] : 0u;
    }
    const double factor = sum / static_cast<double>(kRowOne);
    const double error = factor - exact_from(solution.device().mesh.elements[e].centroid, is_parallel);
    result.mean += factor;
    result.rms += error * error;
    ++count;
  }
  result.mean /= count;
  result.rms = std::sqrt(result.rms / count);
  return result;
}

struct Case {
  const char* name;
  Engine engine;
  double bound_at_8;  // relative error of the mean at R = 8; halves with every doubling, down to the floor
};

class SquaresBy : public testing::TestWithParam<Case> {
 protected:
  // What is left at any resolution: 10 x 10 eyes stand for the area, the grid and the lifted eye.
  static constexpr double kFloor = 0.002;

  void expect_bounds(bool is_parallel, double exact) {
    double bound = GetParam().bound_at_8;
    double first_rms = 0, previous_rms = 1;
    for (const int resolution : kResolutions) {
      const SquareFactor factor = measure(is_parallel, GetParam().engine, resolution);
      const double error = std::abs(factor.mean / exact - 1);
      RecordProperty("error_percent_R" + std::to_string(resolution), std::to_string(100 * error));
      RecordProperty("rms_R" + std::to_string(resolution), std::to_string(factor.rms));
      EXPECT_LT(error, std::max(kFloor, bound)) << "R = " << resolution;
      EXPECT_LT(factor.rms, previous_rms) << "R = " << resolution;
      first_rms = resolution == 8 ? factor.rms : first_rms;
      previous_rms = factor.rms;
      bound /= 2;
    }
    EXPECT_LT(previous_rms, first_rms / 5);
  }
};

TEST_P(SquaresBy, MatchTheClosedFormOfParallelSquares) {
  expect_bounds(true, kParallelUnitSquares);
}

TEST_P(SquaresBy, MatchTheClosedFormOfPerpendicularSquares) {
  expect_bounds(false, kPerpendicularUnitSquares);
}

INSTANTIATE_TEST_SUITE_P(Engine, SquaresBy,
                         testing::Values(Case{"Rows", hemicube_rows, 0.02},
                                         Case{"Pixels", hemicube_pixels, 0.04}),
                         [](const auto& c) { return c.param.name; });

SolveOptions plate_options() {
  SolveOptions options;
  options.elements = 288;
  options.settings = settings_with(32, fraction(1, 10000));
  return options;
}

TEST(ParallelPlates, ABlackEmitterLightsTheOtherByExactlyTheFormFactor) {
  constexpr double kBound = 0.005;
  Solution solution(parallel_squares(0.0, 1.0, 0.5), plate_options());
  ASSERT_EQ(solution.run(), Status::converged);
  const std::vector<double> means = solution.face_means();
  EXPECT_NEAR(means[0], 1.0, 1e-4);
  EXPECT_NEAR(means[1] / (0.5 * kParallelUnitSquares), 1.0, kBound);
}

// B1 = E + r1 F B2, B2 = r2 F B1 for uniform plates; that light comes back mostly to the middle changes the
// means by less than the bound.
TEST(ParallelPlates, ReachTheClosedFormOfTwoUniformPlates) {
  constexpr double kBound = 0.01;
  for (const double reflectance : {0.3, 0.6, 0.9}) {
    Solution solution(parallel_squares(reflectance, 1.0, reflectance), plate_options());
    ASSERT_EQ(solution.run(), Status::converged);
    const double f = kParallelUnitSquares * reflectance;
    const std::vector<double> means = solution.face_means();
    EXPECT_NEAR(means[0] * (1 - f * f), 1.0, kBound);
    EXPECT_NEAR(means[1] * (1 - f * f) / f, 1.0, kBound);
    const Ledger total = ledger(solution.state(), 0);
    EXPECT_GT(total.escaped, total.emitted / 2) << "most light leaves between the plates";
  }
}

}  // namespace
}  // namespace fixrad::host

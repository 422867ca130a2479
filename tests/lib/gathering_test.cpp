// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/lib/gathered.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

// Whatever eye is asked for, the one at the centre of its element looks, without a turn: shooting and
// gathering then use the same rows.
Status look_from_the_centre(const Scene& scene, const DeltaTable& table, const EyeSample& sample,
                            Workspace& work, FormFactorRow& row) {
  EyeSample centred = sample;
  centred.eye.turn = 0;
  std::int64_t nearest = -1;
  for (unsigned e = 0; e < scene.element_count; ++e) {
    const EyePoint eye = element_eye(scene, e);
    const Vec3 d = eye.position - sample.eye.position;
    const std::int64_t distance = std::int64_t{d.x} * d.x + std::int64_t{d.y} * d.y + std::int64_t{d.z} * d.z;
    if (eye.face == sample.eye.face && (nearest < 0 || distance < nearest)) {
      nearest = distance;
      centred.eye.position = eye.position;
    }
  }
  return hemicube_rows(scene, table, centred, work, row);
}

SolveOptions options_with(Engine engine) {
  SolveOptions options;
  options.elements = 120;
  options.settings = settings_with(16, fraction(1, 10000));
  options.settings.engine = engine;
  return options;
}

Difference shooting_against_gathering(const Model& model, const SolveOptions& options) {
  Solution shot(model, options), gathered(model, options);
  EXPECT_EQ(shot.run(), Status::converged);
  gather(gathered);
  return relative_difference(shot.radiosities(), gathered.radiosities());
}

TEST(Gathering, EqualsShootingWithTheSameEyes) {
  constexpr double kLargest = 0.002, kMean = 0.0005;  // of the mean radiosity: truncation and rounding alone
  SolveOptions options = options_with(look_from_the_centre);
  options.settings.flux_per_row = Fraction::from_raw(0);  // every element shoots for itself to the end
  for (const Model& model : {cube(0.7, {0, 0, 0, 1, 0, 0}), room_with_box(Stand::floating, 0.3), cornell()}) {
    const Difference difference = shooting_against_gathering(model, options);
    RecordProperty("largest", std::to_string(difference.largest));
    EXPECT_LT(difference.largest, kLargest);
    EXPECT_LT(difference.mean, kMean);
  }
}

TEST(Gathering, IsNearShootingWithItsOwnEyes) {
  constexpr double kMean = 0.02;  // strong shots have several eyes, and every eye another turn
  for (const Model& model : {cube(0.7, {0, 0, 0, 1, 0, 0}), cornell()}) {
    EXPECT_LT(shooting_against_gathering(model, options_with(hemicube_rows)).mean, kMean);
  }
}

TEST(Gathering, SweepsUntilNoMoreThanTheWantedFractionMoves) {
  SolveOptions strict = options_with(hemicube_rows), loose = strict;
  strict.settings.stop = fraction(1, 100000);
  loose.settings.stop = fraction(1, 10);
  Solution a(cube(0.9, {1, 0, 0, 0, 0, 0}), strict), b(cube(0.9, {1, 0, 0, 0, 0, 0}), loose);
  EXPECT_GT(gather(a), gather(b));
  EXPECT_LE(sum_unshot(a.state(), 0).magnitude, static_cast<std::uint64_t>(a.state().emitted[0]) / 1000);
}

TEST(Gathering, ReportsAFullSpanPool) {
  SolveOptions options = options_with(hemicube_rows);
  options.spans = 2;
  Solution solution(cornell(), options);
  const std::size_t n = solution.state().scene.element_count;
  std::vector<std::uint16_t> share(n * n), back(n);
  std::vector<std::int32_t> exitent(n * 3);
  FormFactorMatrix matrix = {share.data(), back.data(), exitent.data()};
  EXPECT_EQ(sample_matrix_row(solution.state(), matrix, 0), Status::span_pool_full);
}

}  // namespace
}  // namespace fixrad::host

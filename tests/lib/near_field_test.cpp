// SPDX-License-Identifier: MIT
// The near-field correction of finished rows.
#include "lib/form_factor/near_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/transport/sampling.h"
#include "tests/lib/closed_forms.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

SolveOptions near_options(std::uint32_t elements, bool corrected) {
  SolveOptions options;
  options.elements = elements;
  options.settings.engine = lune_rows;
  options.settings.tables = kLunes + 2;
  options.settings.table_count = 1;
  options.settings.near_field = corrected ? correct_near_field : nullptr;
  return options;
}

// The row of element `e` from one eye.
void sample(State& state, std::uint16_t e) {
  ASSERT_EQ(sample_element(state, e, 1, 16), Status::ok);
}

std::uint64_t total(const State& state) {
  std::uint64_t sum = state.row.escaped + state.row.back;
  for (unsigned j = 0; j < state.scene.element_count; ++j) {
    sum += state.row.share[j];
  }
  return sum;
}

// Two plates a quarter of an element apart, one element each: the lower one's centre sees far more of the
// upper one than the lower plate does on average.
Model narrow_gap() {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, 0);
  builder.polygon({{0, 0.25, 0}, {1, 0.25, 0}, {1, 0.25, 1}, {0, 0.25, 1}}, 0);
  return builder.model();
}

TEST(NearField, GivesPlatesThatAlmostTouchTheirClosedForm) {
  Solution solution(narrow_gap(), near_options(2, true));
  State& state = solution.state();
  ASSERT_EQ(state.scene.element_count, 2);
  const double exact = parallel_form_factor({0, 1, 0, 1}, {0, 1, 0, 1}, 0.25);
  sample(state, 0);
  const double from_centre = state.row.share[1] / double{kRowOne};
  correct_near_field(state.scene, 0, state.work, state.row);
  EXPECT_EQ(total(state), kRowOne);
  EXPECT_LT(std::abs(state.row.share[1] / double{kRowOne} - exact), 0.25 * std::abs(from_centre - exact));
}

// By reciprocity: a small plate near the border of a large one is nothing to the large one's centre.
TEST(NearField, SamplesTheSmallerOfTheTwo) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, 0);
  builder.polygon({{0.7, 0.1, 0.5}, {0.8, 0.1, 0.5}, {0.8, 0.1, 0.6}, {0.7, 0.1, 0.6}}, 0);
  Solution solution(builder.model(), near_options(2, true));
  State& state = solution.state();
  ASSERT_EQ(state.scene.element_count, 2);
  const double exact = parallel_form_factor({0, 1, 0, 1}, {0.7, 0.8, 0.5, 0.6}, 0.1);
  sample(state, 0);
  correct_near_field(state.scene, 0, state.work, state.row);
  EXPECT_NEAR(state.row.share[1] / double{kRowOne}, exact, 0.01 * exact);
  EXPECT_EQ(total(state), kRowOne);
}

TEST(NearField, LeavesRowsWithoutNearPairsAsTheyAre) {
  Solution solution(cube(0.5, {1, 0, 0, 0, 0, 0}), near_options(150, true));
  State& state = solution.state();
  for (std::uint16_t e = 0; e < state.scene.element_count; e = static_cast<std::uint16_t>(e + 11)) {
    sample(state, e);
    const std::vector<std::uint32_t> before(state.row.share, state.row.share + state.scene.element_count);
    correct_near_field(state.scene, e, state.work, state.row);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), state.row.share)) << "element " << e;
  }
}

TEST(NearField, KeepsTheSumOfEveryRowAndTheLedger) {
  for (const Model& model : {cornell(), random_closed_room(6), random_open_room(2)}) {
    SolveOptions options = near_options(150, true);
    Solution solution(model, options);
    State& state = solution.state();
    for (std::uint16_t e = 0; e < state.scene.element_count; ++e) {
      ASSERT_EQ(sample_element(state, e, 4, 64), Status::ok);
      correct_near_field(state.scene, e, state.work, state.row);
      ASSERT_EQ(total(state), kRowOne) << "element " << e;
    }
    ASSERT_EQ(solution.run(), Status::converged);
    EXPECT_EQ(solution.imbalance(), 0);
  }
}

TEST(NearField, MakesNoLightEscapeFromAClosedRoom) {
  Solution solution(random_closed_room(6), near_options(100, true));
  ASSERT_EQ(solution.run(), Status::converged);
  EXPECT_EQ(solution.state().escaped[0], 0);
}

}  // namespace
}  // namespace fixrad::host

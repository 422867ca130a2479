// SPDX-License-Identifier: MIT
// What a convex scene is spared, and that nothing but time tells.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/simulate/convexity.h"
#include "lib/form_factor/row_sampling.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A room on a regular polygon, seen from inside; turned by `angle`, so that no wall is parallel to an axis.
Model prism_room(int sides, double angle) {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.6));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.2), glm::dvec3(5.0));
  std::vector<glm::dvec3> floor, ceiling;
  for (int i = 0; i < sides; ++i) {
    const double a = angle + 2 * kPi * i / sides;
    floor.emplace_back(2 * std::sin(a), 0, 2 * std::cos(a));
    ceiling.emplace_back(2 * std::sin(a), 2.5, 2 * std::cos(a));
  }
  for (std::size_t i = 0; i < floor.size(); ++i) {
    const std::size_t next = (i + 1) % floor.size();
    builder.polygon({floor[next], floor[i], ceiling[i], ceiling[next]}, wall);
  }
  builder.polygon(floor, wall);
  builder.polygon({ceiling.rbegin(), ceiling.rend()}, lamp);
  return builder.model();
}

// Three squares of a cube's corner, all seen from inside: convex and open.
Model open_corner() {
  ModelBuilder builder;
  const std::uint32_t lit = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, lit);
  builder.polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, lit);
  builder.polygon({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, lit);
  return builder.model();
}

// A floor of 2 x 2 m, and a lamp of 1 m in its plane: beside it, or on it.
Model floor_and_lamp(double lamp_x) {
  ModelBuilder builder;
  const std::uint32_t floor = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.0), glm::dvec3(1.0));
  builder.polygon({{0, 0, 0}, {0, 0, 2}, {2, 0, 2}, {2, 0, 0}}, floor);
  builder.polygon({{lamp_x, 0, 0.5}, {lamp_x, 0, 1.5}, {lamp_x + 1, 0, 1.5}, {lamp_x + 1, 0, 0.5}}, lamp);
  return builder.model();
}

struct Sample {
  const char* name;
  Model model;
};

std::vector<Sample> convex_scenes() {
  return {{"cube", cube(0.5, {1, 1, 1, 1, 1, 1})},
          {"six walls", prism_room(6, 0.1)},
          {"eight walls", prism_room(8, 0.3)},
          {"three walls", prism_room(3, 0.7)},
          {"corner", open_corner()},
          {"plates", parallel_squares(0.5, 1.0, 0.5)},
          {"right angle", perpendicular_squares(0.5, 1.0, 0.5)}};
}

SolveOptions lune_options() {
  SolveOptions options;
  options.elements = 120;
  options.settings = lune_settings(32, fraction(1, 200));
  return options;
}

TEST(Convex, RoomsOfFlatWallsPlatesAndCornersAre) {
  for (Sample& sample : convex_scenes()) {
    EXPECT_TRUE(is_convex(Solution(std::move(sample.model), lune_options()).device())) << sample.name;
  }
}

TEST(Convex, NoSceneInWhichABodyStandsIs) {
  for (const Stand stand : {Stand::without_bottom, Stand::closed_on_floor, Stand::floating}) {
    EXPECT_FALSE(is_convex(Solution(room_with_box(stand, 0.3), lune_options()).device()));
  }
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    EXPECT_FALSE(is_convex(Solution(random_closed_room(seed), lune_options()).device())) << seed;
  }
  EXPECT_FALSE(is_convex(Solution(cornell(), lune_options()).device()));
}

TEST(Convex, ALampBesideTheFloorHidesNothingALampOnTheFloorDoes) {
  EXPECT_TRUE(is_convex(Solution(floor_and_lamp(2.0), lune_options()).device()));
  EXPECT_TRUE(is_convex(Solution(floor_and_lamp(3.0), lune_options()).device()));
  EXPECT_FALSE(is_convex(Solution(floor_and_lamp(0.5), lune_options()).device()));
  EXPECT_FALSE(is_convex(Solution(floor_and_lamp(1.5), lune_options()).device()));
}

// Where no two faces ever meet on a row, no view has made a depth.
TEST(ConvexScenes, MakeNoDepthFromAnyEyeInAnyTurn) {
  for (Sample& sample : convex_scenes()) {
    Solution solution(std::move(sample.model), lune_options());
    State& state = solution.state();
    const DeltaTable& table = state.settings.tables[state.settings.table_count - 1];
    std::uint32_t views = 0;
    for (std::uint32_t e = 0; e < state.scene.element_count; ++e) {
      for (std::uint8_t turn = 0; turn < kTurns; ++turn) {
        const EyeSample eye = {element_eye(state.scene, e, turn), kRowOne, !state.is_closed};
        ASSERT_EQ(lune_rows(state.scene, table, eye, state.work, state.row), Status::ok);
        for (std::uint16_t i = 0; i < state.work.view_count; ++i, ++views) {
          ASSERT_EQ(state.work.views[i].depth_shift, 0)
              << sample.name << " element " << e << " turn " << int{turn};
        }
      }
    }
    EXPECT_GE(views, state.scene.element_count * std::uint32_t{kTurns}) << sample.name;
  }
}

// All spans of a band of lunes from one eye.
std::vector<std::uint32_t> spans_seen(State& state, const EyePoint& eye, bool depths_first) {
  const DeltaTable& table = *lune_table(32);
  Workspace& work = state.work;
  make_view(state.scene, eye, Backs::all, work);
  if (depths_first) {
    make_depths(state.scene, eye, work);
  }
  enter_band(state.scene, table, 0, kBandRows, work);
  VisibleSpans visible(state.scene, eye, work);
  std::vector<std::uint32_t> seen;
  for (int r = 0; r < kBandRows; ++r) {
    EXPECT_TRUE(find_visible(state.scene, band_row(table, 0, r), work, visible));
    for (std::uint16_t i = 0; i < visible.count(); ++i) {
      seen.push_back(static_cast<std::uint32_t>(visible.part(i).begin) << 16 | visible.view(i));
    }
  }
  return seen;
}

void expect_equal_spans(Solution& solution) {
  State& state = solution.state();
  for (std::uint32_t e = 0; e < state.scene.element_count; ++e) {
    for (std::uint8_t turn = 0; turn < kTurns; ++turn) {
      const EyePoint eye = element_eye(state.scene, e, turn);
      ASSERT_EQ(spans_seen(state, eye, false), spans_seen(state, eye, true))
          << "element " << e << " turn " << int{turn};
    }
  }
}

TEST(Depth, LeftOutInConvexScenesChangesNoSpan) {
  for (Sample& sample : convex_scenes()) {
    SCOPED_TRACE(sample.name);
    Solution solution(std::move(sample.model), lune_options());
    ASSERT_NO_FATAL_FAILURE(expect_equal_spans(solution));
  }
}

TEST(Depth, MadeAtTheFirstMeetingShowsWhatDepthMadeBeforehandShows) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    SolveOptions options = lune_options();
    options.spans = 400;
    Solution solution(random_open_room(seed), options);
    ASSERT_NO_FATAL_FAILURE(expect_equal_spans(solution));
  }
}

}  // namespace
}  // namespace fixrad::host

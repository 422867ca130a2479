// SPDX-License-Identifier: MIT
// In a closed scene every row is complete, from the eyes of the elements and from anywhere inside.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

SolveOptions options_of(Engine engine, int resolution, std::uint32_t elements) {
  SolveOptions options;
  options.elements = elements;
  options.settings = engine == lune_rows ? lune_settings(resolution, fraction(1, 1000))
                                         : settings_with(resolution, fraction(1, 1000));
  options.settings.engine = engine;
  return options;
}

// Fills state.row from one eye and returns the sum over the elements.
std::uint32_t look(State& state, const EyePoint& eye, bool back_faces) {
  clear(state.row);
  const EyeSample sample = {eye, kRowOne, back_faces};
  const DeltaTable& finest = state.settings.tables[state.settings.table_count - 1];
  EXPECT_EQ(state.settings.engine(state.scene, finest, sample, state.work, state.row), Status::ok);
  return std::accumulate(state.row.share, state.row.share + state.row.count, std::uint32_t{0});
}

class ClosedScene : public testing::TestWithParam<Engine> {};

// The bottom of a body that stands on the floor looks down, out of the room; no light ever comes there.
bool is_bottom_in_the_floor(const Solution& solution, unsigned element) {
  const MeshElement& e = solution.device().mesh.elements[element];
  return e.normal.y < -0.9 && e.centroid.y < 0.01;
}

TEST_P(ClosedScene, RowsSumToOneForTheEyeOfEveryElement) {
  unsigned eyes = 0;
  for (std::uint32_t seed = 200; seed < 220; ++seed) {
    Solution solution(random_closed_room(seed), options_of(GetParam(), 16, 90));
    State& state = solution.state();
    ASSERT_TRUE(state.is_closed);
    for (unsigned e = 0; e < state.scene.element_count; ++e) {
      if (is_bottom_in_the_floor(solution, e)) {
        continue;
      }
      const EyePoint eye = element_eye(state.scene, e, static_cast<std::uint8_t>(e));
      ASSERT_EQ(look(state, eye, false), kRowOne) << "seed " << seed << " element " << e;
      ASSERT_EQ(state.row.escaped, 0u);
      ASSERT_EQ(state.row.back, 0u);
      ++eyes;
    }
  }
  EXPECT_GT(eyes, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Engine, ClosedScene, testing::Values(hemicube_rows, hemicube_pixels, lune_rows),
                         [](const auto& engine) {
                           return engine.index == 0 ? "Rows" : (engine.index == 1 ? "Pixels" : "Lunes");
                         });

// Views from random eyes in the lower `height` of a room without bodies there, looking up from its floor.
class RandomViews {
 public:
  RandomViews(Solution& solution, std::uint32_t seed, double height)
      : state_(solution.state()), random_(seed), scene_(solution.device()), height_(height) {
    for (std::uint16_t f = 0; f < state_.scene.face_count; ++f) {
      if (solution.prepared().faces[f].parts.front().input_face == 2) {
        floor_ = f;
      }
    }
    for (const Vertex& v : scene_.vertices) {
      high_ = {std::max<std::int32_t>(high_.x, v.x), std::max<std::int32_t>(high_.y, v.y),
               std::max<std::int32_t>(high_.z, v.z)};
      low_ = {std::min<std::int32_t>(low_.x, v.x), std::min<std::int32_t>(low_.y, v.y),
              std::min<std::int32_t>(low_.z, v.z)};
    }
  }

  /// An eye at least `margin` grid units from every wall but the floor; half of them on the floor itself.
  EyePoint eye(int margin) {
    const int top = low_.y + static_cast<int>(height_ * (high_.y - low_.y)) - margin;
    const int x = random_.between(kEyeScale * (low_.x + margin), kEyeScale * (high_.x - margin));
    const int z = random_.between(kEyeScale * (low_.z + margin), kEyeScale * (high_.z - margin));
    const int y = random_.between(0, 1) == 0 ? kEyeScale * low_.y + 2
                                             : random_.between(kEyeScale * low_.y + 2, kEyeScale * top);
    return {{x, y, z}, floor_, static_cast<std::uint8_t>(random_.between(0, kTurns - 1))};
  }

  /// Looks `count` times; the test fails at the first hole.
  void expect_none_leaks(int count, int margin, bool back_faces) {
    for (int i = 0; i < count; ++i) {
      const EyePoint from = eye(margin);
      const std::uint32_t sum = look(state_, from, back_faces);
      ASSERT_TRUE(sum == kRowOne && state_.row.escaped == 0 && state_.row.back == 0)
          << "eye " << from.position.x << ' ' << from.position.y << ' ' << from.position.z << " turn "
          << int{from.turn} << ": escaped " << state_.row.escaped << " back " << state_.row.back;
    }
  }

 private:
  State& state_;
  Random random_;
  const DeviceScene& scene_;
  double height_;
  Vec3 low_ = {kGridMax, kGridMax, kGridMax}, high_ = {0, 0, 0};
  std::uint16_t floor_ = 0;
};

// A room whose bodies hang in its upper half.
Model room_with_hanging_bodies(std::uint32_t seed) {
  Random random(seed);
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.room(glm::dvec3(0.0), {4.0, 3.0, 4.0}, {wall, wall, wall, wall, wall, wall});
  for (const double x : {1.0, 3.0}) {
    for (const double z : {1.0, 3.0}) {
      const double r = random.real(0.1, 0.6);
      if (random.between(0, 1) == 0) {
        builder.octahedron({x, 2.3, z}, r, random.real(0.0, 1.5), wall);
      } else {
        builder.box({x - r, 1.7, z - r}, {x + r, random.real(1.9, 2.9), z + r}, random.real(0.0, 1.5), wall);
      }
    }
  }
  return builder.model();
}

constexpr int kTwoPermille = 33;  // of the longest side of the grid

TEST(Watertight, SixtyThousandRandomViewsOfACubeShowNoGap) {
  Solution solution(cube(0.5, {1, 1, 1, 1, 1, 1}), options_of(hemicube_rows, 8, 6));
  RandomViews views(solution, 1, 1.0);
  views.expect_none_leaks(30000, kTwoPermille, false);
  views.expect_none_leaks(30000, kTwoPermille, true);
  EXPECT_EQ(solution.state().work.gaps_closed, 0u);
}

TEST(Watertight, FortyThousandRandomViewsOfFurnishedRoomsShowNoGap) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Solution solution(room_with_hanging_bodies(seed), options_of(hemicube_rows, 8, 40));
    ASSERT_TRUE(solution.state().is_closed);
    RandomViews views(solution, seed, 0.5);
    views.expect_none_leaks(2000, kTwoPermille, false);
    EXPECT_EQ(solution.state().work.gaps_closed, 0u) << "seed " << seed;
  }
}

TEST(Watertight, RandomViewsCloseToAWallLoseNothing) {
  Solution solution(cube(0.5, {1, 1, 1, 1, 1, 1}), options_of(hemicube_rows, 8, 6));
  RandomViews(solution, 3, 1.0).expect_none_leaks(20000, 1, false);
}

TEST(Watertight, RandomViewsByLunesShowNoGap) {
  Solution box(cube(0.5, {1, 1, 1, 1, 1, 1}), options_of(lune_rows, 16, 6));
  RandomViews views(box, 5, 1.0);
  views.expect_none_leaks(20000, kTwoPermille, false);
  views.expect_none_leaks(10000, kTwoPermille, true);
  EXPECT_EQ(box.state().work.gaps_closed, 0u);
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Solution solution(room_with_hanging_bodies(seed), options_of(lune_rows, 16, 40));
    RandomViews(solution, seed, 0.5).expect_none_leaks(1000, kTwoPermille, false);
    EXPECT_EQ(solution.state().work.gaps_closed, 0u) << "seed " << seed;
  }
}

TEST(Watertight, RandomViewsByPixelsLoseNothing) {
  Solution solution(cube(0.5, {1, 1, 1, 1, 1, 1}), options_of(hemicube_pixels, 8, 6));
  RandomViews(solution, 4, 1.0).expect_none_leaks(10000, kTwoPermille, true);
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// Eye points under bodies that stand on their face.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

// Eyes by which light was really sent: those of a shot that were not withdrawn.
struct UsedEyes {
  std::vector<EyeSample> pending, used;

  Observer observer() {
    return {this,
            [](void* self, const DeltaTable&, const EyeSample& sample) {
              static_cast<UsedEyes*>(self)->pending.push_back(sample);
            },
            [](void* self, const Shot&) {
              auto& eyes = *static_cast<UsedEyes*>(self);
              eyes.used.insert(eyes.used.end(), eyes.pending.begin(), eyes.pending.end());
              eyes.pending.clear();
            },
            [](void* self) { static_cast<UsedEyes*>(self)->pending.clear(); }};
  }
};

SolveOptions options_of(std::uint32_t elements, std::uint32_t patches) {
  SolveOptions options;
  options.elements = elements;
  options.patches = patches;
  options.settings = settings_with(16, fraction(1, 500));
  return options;
}

// The box covers 1.5 .. 2.5 m in x and z of the floor (y = 0) of the 4 m room.
bool is_under_box(glm::dvec3 p, double margin) {
  return std::abs(p.y) < 0.01 && std::abs(p.x - 2) < 0.5 - margin && std::abs(p.z - 2) < 0.5 - margin;
}

glm::dvec3 in_metres(const Solution& solution, Vec3 eye) {
  return solution.device().grid.to_scene(glm::dvec3(eye.x, eye.y, eye.z) / static_cast<double>(kEyeScale));
}

class StandingBox : public testing::TestWithParam<Stand> {};

TEST_P(StandingBox, NoEyeUnderItShoots) {
  for (const std::uint32_t patches : {60u, 300u}) {
    UsedEyes eyes;
    SolveOptions options = options_of(300, patches);
    options.settings.observer = eyes.observer();
    Solution solution(room_with_box(GetParam(), 0.0), options);
    ASSERT_EQ(solution.run(), Status::converged);
    ASSERT_FALSE(eyes.used.empty());
    for (const EyeSample& sample : eyes.used) {
      const glm::dvec3 p = in_metres(solution, sample.eye.position);
      const bool is_floor = solution.prepared().faces[sample.eye.face].normal.y > 0.9 && p.y < 0.01;
      ASSERT_FALSE(is_floor && is_under_box(p, 0.01)) << p.x << ' ' << p.z;
    }
    EXPECT_EQ(solution.imbalance(), 0);
  }
}

TEST_P(StandingBox, GroupedPatchesWithdrawBuriedEyes) {
  Solution solution(room_with_box(GetParam(), 0.0), options_of(300, 60));
  ASSERT_EQ(solution.run(), Status::converged);
  EXPECT_GT(solution.state().withdrawn, 0u);
}

TEST_P(StandingBox, LosesNextToNothing) {
  constexpr double kLost = 0.002;  // of the emitted flux, to back faces seen by eyes on the edge
  for (const double angle : {0.0, 0.4}) {
    Solution solution(room_with_box(GetParam(), angle), options_of(300, 300));
    ASSERT_EQ(solution.run(), Status::converged);
    const Ledger total = ledger(solution.state(), 0);
    EXPECT_LT(static_cast<double>(total.back + total.escaped), kLost * static_cast<double>(total.emitted));
  }
}

TEST_P(StandingBox, NoLightArrivesUnderIt) {
  constexpr double kDark = 0.005;  // of the mean radiosity
  Solution solution(room_with_box(GetParam(), 0.0), options_of(600, 600));
  ASSERT_EQ(solution.run(), Status::converged);
  const std::vector<double> all = solution.radiosities();
  double mean = 0;
  for (const double b : all) {
    mean += b / static_cast<double>(all.size());
  }
  int covered = 0;
  for (std::size_t e = 0; e < all.size(); ++e) {
    const MeshElement& element = solution.device().mesh.elements[e];
    const bool is_covered =
        element.normal.y > 0.9 && std::all_of(element.polygon.begin(), element.polygon.end(),
                                              [](const glm::dvec3& p) { return is_under_box(p, -1e-3); });
    if (is_covered) {
      ++covered;
      EXPECT_LT(all[e], kDark * mean) << "element " << e;
    }
  }
  EXPECT_GT(covered, 0);
}

INSTANTIATE_TEST_SUITE_P(Box, StandingBox, testing::Values(Stand::without_bottom, Stand::closed_on_floor),
                         [](const auto& s) { return s.index == 0 ? "WithoutBottom" : "ClosedOnFloor"; });

TEST(FloatingBox, WithdrawsNothing) {
  Solution solution(room_with_box(Stand::floating, 0.3), options_of(300, 300));
  ASSERT_EQ(solution.run(), Status::converged);
  EXPECT_TRUE(solution.state().is_closed);
  EXPECT_EQ(solution.state().withdrawn, 0u);
}

TEST(BackShare, IsOneInsideAClosedBodyAndZeroInTheOpen) {
  Solution solution(room_with_box(Stand::closed_on_floor, 0.2), options_of(60, 60));
  State& state = solution.state();
  std::uint32_t floor = 0;
  while (solution.prepared().faces[floor].parts.front().input_face != 2) {
    ++floor;
  }
  const auto share_at = [&](double x, double z) {
    const glm::dvec3 p =
        (glm::dvec3(x, 0.0, z) - solution.device().grid.origin) * solution.device().grid.scale;
    const EyePoint eye = {
        {static_cast<std::int32_t>(kEyeScale * p.x), static_cast<std::int32_t>(kEyeScale * p.y) + 2,
         static_cast<std::int32_t>(kEyeScale * p.z)},
        static_cast<std::uint16_t>(floor),
        5};
    std::uint32_t share = 0;
    EXPECT_EQ(hidden_share(state.scene, kDelta8, eye, false, state.work, share), Status::ok);
    return share;
  };
  EXPECT_EQ(share_at(2.0, 2.0), kRowOne);
  EXPECT_EQ(share_at(2.3, 1.8), kRowOne);
  EXPECT_EQ(share_at(0.5, 0.5), 0u);
  EXPECT_EQ(share_at(3.9, 2.0), 0u);
}

// A lamp body with the floor or the ceiling in contact: its hidden face looks out behind the wall.
class LampInContact : public testing::TestWithParam<double> {};

TEST_P(LampInContact, LosesNoLightFromAClosedRoom) {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.7, 0.6, 0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.2), glm::dvec3(5.0));
  builder.room({0, 0, 0}, {4, 2.5, 3}, {wall, wall, wall, wall, wall, wall});
  builder.box({1, GetParam(), 1}, {1.5, GetParam() + 0.25, 1.5}, 0.0, lamp);
  Solution solution(builder.model(), options_of(200, 200));
  ASSERT_EQ(solution.run(), Status::converged);
  ASSERT_TRUE(solution.state().is_enclosed);
  for (int c = 0; c < 3; ++c) {
    const Ledger sum = ledger(solution.state(), c);
    EXPECT_EQ(sum.imbalance(), 0);
    EXPECT_EQ(sum.escaped, 0);
    EXPECT_EQ(sum.back, 0);
    EXPECT_GT(sum.absorbed, sum.emitted * 99 / 100);
  }
}

INSTANTIATE_TEST_SUITE_P(FloorAndCeiling, LampInContact, testing::Values(0.0, 2.25));

TEST(Enclosed, ABodyInEmptySpaceIsClosedButItsLightEscapes) {
  ModelBuilder builder;
  builder.box({0, 0, 0}, {1, 1, 1}, 0.0, builder.material(glm::dvec3(0.5), glm::dvec3(1.0)));
  Solution solution(builder.model(), options_of(24, 24));
  EXPECT_TRUE(solution.state().is_closed);
  EXPECT_FALSE(solution.state().is_enclosed);
  ASSERT_EQ(solution.run(), Status::converged);
  const Ledger sum = ledger(solution.state(), 0);
  EXPECT_EQ(sum.escaped + sum.unshot, sum.emitted);
}

}  // namespace
}  // namespace fixrad::host

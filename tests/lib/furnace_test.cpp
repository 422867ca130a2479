// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr std::array<double, 6> kAllEmit = {1, 1, 1, 1, 1, 1};

double worst_face(double reflectance, Fraction stop, std::uint32_t patches) {
  SolveOptions options;
  options.patches = patches;
  options.settings = settings_with(16, stop);
  Solution solution(cube(reflectance, kAllEmit), options);
  EXPECT_EQ(solution.run(), Status::converged);
  double worst = 0;
  for (const double b : solution.face_means()) {
    worst = std::max(worst, std::abs(b * (1 - reflectance) - 1));
  }
  return worst;
}

class Furnace : public testing::TestWithParam<double> {};

// A closed enclosure of one reflectance that emits E everywhere has B = E / (1 - reflectance) everywhere.
TEST_P(Furnace, EveryFaceReachesTheClosedForm) {
  constexpr double kBar = 0.005;
  const std::uint32_t patches =
      GetParam() < 0.98 ? 150 : 24;  // light that is reflected 1000 times takes its shots
  const double worst = worst_face(GetParam(), fraction(1, 10000), patches);
  RecordProperty("worst_face_percent", std::to_string(100 * worst));
  EXPECT_LT(worst, kBar);
}

INSTANTIATE_TEST_SUITE_P(Reflectance, Furnace, testing::Values(0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 0.99, 0.999),
                         [](const auto& r) {
                           return "Permille" + std::to_string(std::lround(1000 * r.param));
                         });

TEST(Furnace, HoldsAtTheDefaultStop) {
  constexpr double kBar = 0.005;  // 0.001 of the emitted flux may be unshot
  for (const double reflectance : {0.5, 0.9}) {
    const double worst = worst_face(reflectance, Settings().stop, 150);
    RecordProperty("worst_face_percent", std::to_string(100 * worst));
    EXPECT_LT(worst, kBar);
  }
}

TEST(Shooting, EndsAtReflectance0999) {
  SolveOptions options;
  options.elements = 24;
  options.patches = 6;
  options.settings = settings_with(8, fraction(1, 1000));
  Solution solution(cube(0.999, {1, 0, 0, 0, 0, 0}), options);
  ASSERT_EQ(solution.run(2000000), Status::converged);
}

TEST(Shooting, ConvergesExactlyWhenTheWorstChannelIsUnderTheFraction) {
  SolveOptions options;
  options.settings = settings_with(8, fraction(1, 100));
  Solution solution(cornell(), options);
  const State& state = solution.state();
  std::uint32_t shots = 0;
  bool was_under = false;
  while (shoot(solution.state()) == Status::ok) {
    EXPECT_FALSE(was_under) << "shot on although every channel was under the fraction";
    was_under = true;
    for (int c = 0; c < 3; ++c) {
      const std::uint64_t limit =
          (std::uint64_t{options.settings.stop.raw} * static_cast<std::uint32_t>(state.emitted[c])) >> 32;
      was_under = was_under && unshot_magnitude(state, c) <= limit;
    }
    ASSERT_EQ(state.shots, ++shots);
  }
  EXPECT_TRUE(was_under);
  EXPECT_LE(unshot_fraction(state), options.settings.stop);
}

TEST(Shooting, DoesNothingMoreOnceConverged) {
  SolveOptions options;
  options.settings = settings_with(8, fraction(1, 20));
  Solution solution(cornell(), options);
  ASSERT_EQ(solution.run(), Status::converged);
  const std::uint64_t before = solution.digest();
  const std::uint32_t shots = solution.state().shots;
  EXPECT_EQ(shoot(solution.state()), Status::converged);
  EXPECT_EQ(solution.digest(), before);
  EXPECT_EQ(solution.state().shots, shots);
}

// Fewer and larger shots leave single elements noisier; the faces' means are what must not move.
TEST(Shooting, OvershootingReachesTheSameFaceMeansInFewerShots) {
  constexpr double kBound = 0.005;
  SolveOptions plain, over;
  plain.settings = over.settings = settings_with(16, fraction(1, 1000));
  over.settings.overshoot = true;
  Solution a(cube(0.8, {1, 0, 0, 0, 0, 0}), plain), b(cube(0.8, {1, 0, 0, 0, 0, 0}), over);
  ASSERT_EQ(a.run(), Status::converged);
  ASSERT_EQ(b.run(), Status::converged);
  for (std::size_t f = 0; f < 6; ++f) {
    EXPECT_NEAR(b.face_means()[f] / a.face_means()[f], 1.0, kBound) << "face " << f;
  }
  EXPECT_LT(b.state().shots, a.state().shots);
}

}  // namespace
}  // namespace fixrad::host

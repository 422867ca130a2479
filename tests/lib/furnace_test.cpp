// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/lib/scenes.h"
#include "tests/lib/sources.h"

namespace fixrad::host {
namespace {

constexpr std::array<double, 6> kAllEmit = {1, 1, 1, 1, 1, 1};

double worst_face(double reflectance, const Settings& settings) {
  SolveOptions options;
  options.settings = settings;
  Solution solution(cube(reflectance, kAllEmit), options);
  EXPECT_EQ(solution.run(), Status::converged);
  double worst = 0;
  for (const double b : solution.face_means()) {
    worst = std::max(worst, std::abs(b * (1 - reflectance) - 1));
  }
  return worst;
}

using Furnace = testing::TestWithParam<double>;

class FurnaceByRows : public Furnace {};
class FurnaceByLunes : public Furnace {};

constexpr double kBar = 0.005;

// A closed enclosure of one reflectance that emits E everywhere has B = E / (1 - reflectance) everywhere.
TEST_P(FurnaceByRows, EveryFaceReachesTheClosedForm) {
  const double worst = worst_face(GetParam(), settings_with(16, fraction(1, 10000)));
  RecordProperty("worst_face_percent", std::to_string(100 * worst));
  EXPECT_LT(worst, kBar);
}

TEST_P(FurnaceByLunes, EveryFaceReachesTheClosedForm) {
  const double worst = worst_face(GetParam(), lune_settings(32, fraction(1, 10000)));
  RecordProperty("worst_face_percent", std::to_string(100 * worst));
  EXPECT_LT(worst, kBar);
}

const auto name_of = [](const auto& r) { return "Permille" + std::to_string(std::lround(1000 * r.param)); };
const auto kReflectances = testing::Values(0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 0.99, 0.999);
INSTANTIATE_TEST_SUITE_P(Reflectance, FurnaceByRows, kReflectances, name_of);
INSTANTIATE_TEST_SUITE_P(Reflectance, FurnaceByLunes, kReflectances, name_of);

TEST(Furnace, HoldsAtTheDefaultStop) {
  for (const double reflectance : {0.5, 0.9}) {  // 0.001 of the emitted flux may be unshot
    const double worst = worst_face(reflectance, Settings());
    RecordProperty("worst_face_percent", std::to_string(100 * worst));
    EXPECT_LT(worst, kBar);
  }
}

TEST(Shooting, EndsAtReflectance0999) {
  SolveOptions options;
  options.elements = 24;
  options.settings = settings_with(8, fraction(1, 1000));
  Solution solution(cube(0.999, {1, 0, 0, 0, 0, 0}), options);
  ASSERT_EQ(solution.run(2000000), Status::converged);
}

// A pass is what shots are planned in: none begins once every channel is under the fraction.
TEST(Shooting, EndsWithThePassInWhichTheWorstChannelComesUnderTheFraction) {
  SolveOptions options;
  options.settings = settings_with(8, fraction(1, 100));
  Solution solution(cornell(), options);
  const State& state = solution.state();
  const auto is_under = [&] {
    bool all = true;
    for (int c = 0; c < 3; ++c) {
      const std::uint64_t limit =
          (std::uint64_t{options.settings.stop.raw} * static_cast<std::uint32_t>(state.emitted[c])) >> 32;
      all = all && sum_unshot(state, c).magnitude <= limit;
    }
    return all;
  };
  ShotWatch watch(solution);
  SeenShot seen = {};
  std::uint32_t shots = 0;
  bool was_under = false;
  while (watch.next(seen) == Status::ok) {
    EXPECT_FALSE(was_under && seen.begins_pass)
        << "a pass began although every channel was under the fraction";
    was_under = is_under();
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

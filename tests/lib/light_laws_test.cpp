// SPDX-License-Identifier: MIT
// What a solution owes to physics and to its settings, whatever the order of the shots.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/lib/scenes.h"
#include "tests/lib/sources.h"

namespace fixrad::host {
namespace {

// The project's bar for the fixed-point arithmetic: mean error of an element's radiosity over the scene's
// mean radiosity.
constexpr double kArithmetic = 0.0015;

// More than any of these scenes takes: shooting that does not come to its end is to fail, not to hang.
constexpr int kMostShots = 6000;

SolveOptions options_of(std::uint32_t elements, Fraction stop = fraction(1, 1000)) {
  SolveOptions options;
  options.elements = elements;
  options.settings = lune_settings(32, stop);
  return options;
}

// The largest difference between face means over the mean of `b`.
double face_difference(const Solution& a, const Solution& b, int channel) {
  return relative_difference(a.face_means(channel), b.face_means(channel)).largest;
}

// An eye sees the same whenever it looks.
Status look_without_a_turn(const Scene& scene, const DeltaTable& table, const EyeSample& sample,
                           Workspace& work, FormFactorRow& row) {
  EyeSample still = sample;
  still.eye.turn = 0;
  return lune_rows(scene, table, still, work, row);
}

// Every element shoots for itself, from its centroid with the finest table: the form factors are the same
// whatever the flux, and what the order of the shots changes is arithmetic.
SolveOptions options_of_one_matrix() {
  SolveOptions options = options_of(200, fraction(1, 100000));
  options.settings.engine = look_without_a_turn;
  options.settings.tables = lune_table(32);
  options.settings.table_count = 1;
  options.settings.flux_per_row = Fraction::from_raw(0);
  options.settings.flux_per_eye = Fraction::from_raw(0xffffffffu);
  return options;
}

class Linearity : public testing::TestWithParam<bool> {};

TEST_P(Linearity, HalfTheEmissionGivesHalfTheLight) {
  SolveOptions options = options_of_one_matrix();
  options.settings.overshoot = GetParam();
  Solution whole(cornell(), options);
  ASSERT_EQ(whole.run(kMostShots), Status::converged);
  DeviceScene device = whole.device();
  for (fixrad::Material& material : device.materials) {
    for (std::uint32_t& emission : material.emission) {
      emission /= 2;
    }
  }
  SimulatedDevice half(sizes_for(device, 0, options.settings));
  ASSERT_EQ(half.load(device.view(), options.settings), Status::ok);
  Status status = Status::ok;
  for (int i = 0; i < kMostShots && status == Status::ok; ++i) {
    status = shoot(half.state());
  }
  ASSERT_EQ(status, Status::converged);
  for (int c = 0; c < 3; ++c) {
    std::vector<double> twice;
    for (std::uint16_t e = 0; e < half.state().scene.element_count; ++e) {
      const std::uint32_t raw = element_radiosity(half.state(), e, c, Radiosity::from_raw(0)).raw;
      twice.push_back(2.0 * raw * device.unit_radiosity);
    }
    EXPECT_LT(relative_difference(twice, whole.radiosities(c)).mean, kArithmetic) << "channel " << c;
  }
}

INSTANTIATE_TEST_SUITE_P(Shooting, Linearity, testing::Bool(),
                         [](const auto& s) { return s.param ? "Overshooting" : "Plain"; });

Model room_with_lamps(double east, double west) {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.6));
  const std::uint32_t lit_east = builder.material(glm::dvec3(0.6), glm::dvec3(east));
  const std::uint32_t lit_west = builder.material(glm::dvec3(0.6), glm::dvec3(west));
  builder.room({0, 0, 0}, {4, 3, 3}, {lit_west, lit_east, wall, wall, wall, wall});
  builder.box({1.2, 0.4, 1.1}, {2.1, 1.7, 1.9}, 0.3, wall);
  return builder.model();
}

TEST(Superposition, LampsAddUp) {
  const SolveOptions options = options_of_one_matrix();
  Solution both(room_with_lamps(2, 3), options), east(room_with_lamps(2, 0), options),
      west(room_with_lamps(0, 3), options);
  for (Solution* solution : {&both, &east, &west}) {
    ASSERT_EQ(solution->run(), Status::converged);
  }
  std::vector<double> sum = east.radiosities();
  for (std::size_t e = 0; e < sum.size(); ++e) {
    sum[e] += west.radiosities()[e];
  }
  EXPECT_LT(relative_difference(both.radiosities(), sum).mean, kArithmetic);
}

struct Wish {
  const char* name;
  std::uint32_t parts;  // at most 1/parts of the emitted flux may be left
  bool overshoot;
  Fraction flux_per_row = Settings().flux_per_row;
};

// Every element shoots for itself as long as it has anything to send.
constexpr Fraction kNoGroups = Fraction::from_raw(0);

class Convergence : public testing::TestWithParam<Wish> {};

// An exact ledger does not show divergence; the number of shots and what is left do.
TEST_P(Convergence, ReachesTheWantedFractionInEveryScene) {
  const std::vector<Model> models = {cornell(), cube(0.9, {1, 0, 0, 0, 0, 0}),
                                     room_with_box(Stand::closed_on_floor, 0.3), random_closed_room(11),
                                     random_open_room(12)};
  for (const Model& model : models) {
    SolveOptions options = options_of(80, fraction(1, GetParam().parts));
    options.settings.overshoot = GetParam().overshoot;
    options.settings.flux_per_row = GetParam().flux_per_row;
    Solution solution(model, options);
    ASSERT_EQ(solution.run(kMostShots), Status::converged) << "after " << solution.state().shots << " shots";
    EXPECT_LE(unshot_fraction(solution.state()), options.settings.stop);
    EXPECT_EQ(solution.imbalance(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Stop, Convergence,
    testing::Values(Wish{"Thousandth", 1000, true}, Wish{"HundredThousandth", 100000, false},
                    Wish{"HundredThousandthOvershooting", 100000, true}, Wish{"Millionth", 1000000, false},
                    Wish{"MillionthOvershooting", 1000000, true},
                    Wish{"HundredThousandthByElements", 100000, false, kNoGroups},
                    Wish{"HundredThousandthByElementsOvershooting", 100000, true, kNoGroups},
                    Wish{"ThousandthByElementsOvershooting", 1000, true, kNoGroups}),
    [](const auto& wish) { return wish.param.name; });

TEST(Stop, AStricterOneMovesFaceMeansByNoMoreThanWhatWasLeft) {
  for (const double reflectance : {0.5, 0.9}) {
    const std::array<double, 6> emission = {0, 0, 0, 1, 0, 0};
    Solution loose(cube(reflectance, emission), options_of(96, fraction(1, 1000)));
    Solution strict(cube(reflectance, emission), options_of(96, fraction(1, 1000000)));
    ASSERT_EQ(loose.run(), Status::converged);
    ASSERT_EQ(strict.run(), Status::converged);
    // Emission 1 on one of six faces and its reflections: the mean radiosity is 1/6 / (1 - reflectance). What
    // is unshot, 0.001 of the emission, would still become 0.001 / (1 - reflectance) of radiosity.
    const auto mean = [](const Solution& s) {
      double sum = 0;
      for (const double b : s.face_means()) {
        sum += b / 6;
      }
      return sum;
    };
    EXPECT_NEAR(mean(loose) * 6 * (1 - reflectance), 1.0, 0.001 + kArithmetic);
    EXPECT_NEAR(mean(strict) * 6 * (1 - reflectance), 1.0, 0.000001 + kArithmetic);
    EXPECT_LT(mean(loose), mean(strict));
  }
}

// What the host finds out beforehand saves probes and changes nothing else.
TEST(Sights, GiveTheFaceMeansThatProbingGives) {
  for (const Model& model : {cornell(), room_with_box(Stand::closed_on_floor, 0.2),
                             room_with_box(Stand::without_bottom, 0.0), random_open_room(4)}) {
    Solution known(model, options_of(250), true), probed(model, options_of(250));
    ASSERT_FALSE(known.device().sights.empty());
    ASSERT_TRUE(probed.device().sights.empty());
    ASSERT_EQ(known.run(), Status::converged);
    ASSERT_EQ(probed.run(), Status::converged);
    for (int c = 0; c < known.device().channels; ++c) {
      EXPECT_LT(face_difference(known, probed, c), kArithmetic);
    }
    EXPECT_LE(known.state().withdrawn, probed.state().withdrawn);
  }
}

// Elements of the floor by how many of their corners the box on it (1.5 .. 2.5 m) covers.
TEST(Sights, KnowWhatTheBoxBuries) {
  const Solution solution(room_with_box(Stand::closed_on_floor, 0.0), options_of(400), true);
  int under = 0, across = 0, clear = 0;
  for (std::size_t e = 0; e < solution.device().elements.size(); ++e) {
    const MeshElement& element = solution.device().mesh.elements[e];
    const Sight sight = solution.device().sights.at(e);
    const auto is_covered = [](glm::dvec3 p) {
      return p.y < 0.01 && std::abs(p.x - 2) < 0.499 && std::abs(p.z - 2) < 0.499;
    };
    const auto covered = std::count_if(element.polygon.begin(), element.polygon.end(), is_covered);
    const glm::dvec3 p = element.centroid;
    if (covered == static_cast<std::ptrdiff_t>(element.polygon.size())) {
      EXPECT_EQ(sight, Sight::centroid_buried) << p.x << ' ' << p.z;
      ++under;
    } else if (covered > 0) {
      EXPECT_NE(sight, Sight::all_clear) << p.x << ' ' << p.z;
      ++across;
    } else if (p.y > 3.99 && std::abs(p.x - 2) < 1.2 && std::abs(p.z - 2) < 1.2) {
      EXPECT_EQ(sight, Sight::all_clear) << "ceiling " << p.x << ' ' << p.z;
      ++clear;
    }
  }
  EXPECT_GT(under, 0);
  EXPECT_GT(across, 0);
  EXPECT_GT(clear, 9);
}

// Every element is a lamp, and none has more to send than another.
TEST(ManyEmitters, EachEmitsOnceAndTheFurnaceReachesItsClosedForm) {
  constexpr double kBar = 0.005;
  for (const double reflectance : {0.3, 0.9, 0.99}) {
    SolveOptions options = options_of(400);
    options.settings.flux_per_row = fraction(1, 4000);  // ten rows for what one element emits
    std::size_t emissions = 0;
    options.settings.observer.context = &emissions;
    options.settings.observer.on_shot = [](void* count, const Shot& shot) {
      *static_cast<std::size_t*>(count) += shot.is_emission ? 1u : 0u;
    };
    Solution solution(cube(reflectance, {1, 1, 1, 1, 1, 1}), options);
    ASSERT_EQ(solution.run(), Status::converged);
    EXPECT_EQ(emissions, solution.device().elements.size());
    EXPECT_EQ(solution.imbalance(), 0);
    for (const double b : solution.face_means()) {
      EXPECT_NEAR(b * (1 - reflectance), 1.0, kBar);
    }
  }
}

// The bottom of a box that stands on the floor of a closed room, and nothing else, emits.
Model room_with_lit_bottom(double reflectance) {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(reflectance), glm::dvec3(1.0));
  builder.room({0, 0, 0}, {4, 3, 3}, {wall, wall, wall, wall, wall, wall});
  builder.box({1, 0, 1}, {2, 1, 2}, 0.0, wall, false);
  builder.polygon({{1, 0, 1}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2}}, lamp);
  return builder.model();
}

class Buried : public testing::TestWithParam<bool> {};

// Where all eyes of a source are buried its light stays where it is until it is absorbed, whoever shoots:
// B = E / (1 - reflectance) there, and darkness everywhere else.
TEST_P(Buried, LightStaysOnItsFaceInAClosedScene) {
  constexpr double kReflectance = 0.9;
  Solution solution(room_with_lit_bottom(kReflectance), options_of(200, fraction(1, 2000)), GetParam());
  ASSERT_TRUE(solution.state().is_enclosed);
  ShotWatch watch(solution);
  SeenShot seen = {};
  int groups = 0;
  while (watch.next(seen) == Status::ok) {
    groups += seen.shot.source.kind != SourceKind::element ? 1 : 0;
  }
  EXPECT_GT(groups, 0);
  EXPECT_EQ(solution.imbalance(), 0);
  const std::size_t lamp = solution.face_means().size() - 1;
  for (std::uint32_t e = 0; e < solution.device().elements.size(); ++e) {
    if (solution.device().mesh.elements[e].input_face != lamp) {
      ASSERT_EQ(solution.state().received[e], 0) << "element " << e;
    }
  }
  EXPECT_NEAR(solution.face_means()[lamp] * (1 - kReflectance), 1.0, 0.0005 + kArithmetic);
}

INSTANTIATE_TEST_SUITE_P(Sights, Buried, testing::Bool(),
                         [](const auto& s) { return s.param ? "Known" : "Probed"; });

}  // namespace
}  // namespace fixrad::host

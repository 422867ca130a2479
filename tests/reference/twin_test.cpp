// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <set>
#include <stdexcept>

#include "lib/fixrad.h"
#include "tests/reference/twin_room.h"

namespace fixrad::host {
namespace {

// Mean and largest error of an element's radiosity over the scene's mean radiosity.
struct Bar {
  double mean, max;
};

// The project's bar for fixed-point arithmetic against the same algorithm in double.
constexpr Bar kBar = {0.0015, 0.015};
// Point sampling turns the smallest difference of a border into a whole pixel.
constexpr Bar kPixelBar = {0.003, 0.03};

using TestSolver = Solver<Limits<64, 32, 1024, 256, 3, 32>>;

// A fixed-point run to its end, and the shots it fired.
struct FixedRun {
  explicit FixedRun(const Scene& from, Settings wanted = {})
      : scene(from), recorder(solver->state()), settings(wanted) {
    settings.observer = recorder.observer();
    status = solver->load(scene, settings);
    while (status == Status::ok) {
      status = solver->step();
    }
  }

  std::unique_ptr<Twin> replay() const {
    auto twin = std::make_unique<Twin>(scene, settings);
    twin->replay(recorder);
    return twin;
  }

  Scene scene;
  std::unique_ptr<TestSolver> solver = std::make_unique<TestSolver>();
  Recorder recorder;
  Settings settings;
  Status status;
};

// Both in the core's radiosity unit.
ArithmeticError arithmetic_error(const FixedRun& run, const Twin& twin) {
  std::vector<glm::dvec3> fixed(run.scene.element_count);
  for (std::uint16_t e = 0; e < run.scene.element_count; ++e) {
    for (int c = 0; c < 3; ++c) {
      const int channel = c < run.scene.channels ? c : run.scene.channels - 1;
      fixed[e][c] = element_radiosity(run.solver->state(), e, channel, Radiosity::from_raw(0)).raw;
    }
  }
  const double unit = std::ldexp(1.0, run.scene.radiosity_shift);
  return compare_arithmetic(fixed, twin.element_radiosity(unit, 1.0), twin.scene().element_area);
}

void expect_within(const FixedRun& run, const Bar& bar = kBar) {
  ASSERT_EQ(run.status, Status::converged);
  const ArithmeticError error = arithmetic_error(run, *run.replay());
  EXPECT_LE(error.mean, bar.mean);
  EXPECT_LE(error.max, bar.max);
}

// A box whose ceiling shines. No two of its lengths have a simple ratio: in a cube of round numbers borders
// of elements lie exactly in the middle of a row, and whatever rounds decides about the whole row.
void add_room(TwinRoom& room, unsigned n) {
  const std::uint16_t walls = room.add_material({0.7, 0.5, 0.3}, {0, 0, 0});
  const std::uint16_t lamp = room.add_material({0.5, 0.5, 0.5}, {1, 0.8, 0.5});
  const Vec3 x = {11987, 0, 0}, y = {0, 9103, 0}, z = {0, 0, 7919};
  room.add_quad({0, 0, 0}, x, y, n, walls);
  room.add_quad(z, y, x, n, lamp);
  room.add_quad({0, 0, 0}, z, x, n, walls);
  room.add_quad(y, x, z, n, walls);
  room.add_quad({0, 0, 0}, y, z, n, walls);
  room.add_quad(x, z, y, n, walls);
}

// Stands in the room with its sides at 37 degrees to the walls and hangs clear of the floor.
void add_turned_box(TwinRoom& room, unsigned n) {
  const std::uint16_t paint = room.add_material({0.6, 0.6, 0.2}, {0, 0, 0});
  room.add_box({5000, 3000, 500}, {2400, 1800, 0}, {-1500, 2000, 0}, {0, 0, 4000}, false, n, paint);
}

// An engine and its tables, the coarsest first.
struct Sampling {
  const char* name;
  Engine engine;
  const DeltaTable* tables;
  std::uint8_t table_count;

  Settings settings() const {
    Settings settings;
    settings.engine = engine;
    settings.tables = tables;
    settings.table_count = table_count;
    settings.probe = engine == lune_rows ? kLunes : &kDelta8;
    return settings;
  }
};

const DeltaTable kHemicubes[] = {kDelta8, kDelta16, kDelta32};

class TwinOfRows : public ::testing::TestWithParam<Sampling> {};
class TwinOfPixels : public ::testing::TestWithParam<Sampling> {};

TEST_P(TwinOfRows, ArithmeticErrorOfAnEmptyRoomIsWithinTheBar) {
  TwinRoom room;
  add_room(room, 6);
  expect_within(FixedRun(room.scene(), GetParam().settings()));
}

TEST_P(TwinOfRows, ArithmeticErrorRoundATurnedBoxIsWithinTheBar) {
  TwinRoom room;
  add_room(room, 6);
  add_turned_box(room, 4);
  expect_within(FixedRun(room.scene(), GetParam().settings()));
}

TEST_P(TwinOfPixels, ArithmeticErrorRoundATurnedBoxIsWithinTheBar) {
  TwinRoom room;
  add_room(room, 6);
  add_turned_box(room, 4);
  Settings settings = GetParam().settings();
  settings.flux_per_eye =
      fraction(1, 2000);  // else a pixel of one view is a large part of an element's light
  expect_within(FixedRun(room.scene(), settings), kPixelBar);
}

TEST_P(TwinOfRows, OvershootsAreReplayed) {
  TwinRoom room;
  add_room(room, 6);
  add_turned_box(room, 4);
  Settings overshoot = GetParam().settings();
  overshoot.overshoot = true;
  const FixedRun run(room.scene(), overshoot);
  double largest = 0;
  for (const RecordedShot& shot : run.recorder.shots()) {
    largest = std::max(largest, shot.more[0]);
  }
  EXPECT_GT(largest, 0.001 * run.solver->state().emitted[0]) << "nothing worth replaying was lent";
  expect_within(run);
}

const auto name_of = [](const auto& sampling) { return std::string(sampling.param.name); };

INSTANTIATE_TEST_SUITE_P(Hemicube, TwinOfRows,
                         ::testing::Values(Sampling{"R16", hemicube_rows, &kDelta16, 1},
                                           Sampling{"R32", hemicube_rows, &kDelta32, 1},
                                           Sampling{"R8To32", hemicube_rows, kHemicubes, 3}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Lunes, TwinOfRows,
                         ::testing::Values(Sampling{"R4", lune_rows, kLunes, 1},
                                           Sampling{"R16", lune_rows, kLunes + 2, 1},
                                           Sampling{"R32", lune_rows, kLunes + 3, 1},
                                           Sampling{"R4To32", lune_rows, kLunes, 4},
                                           Sampling{"R16To64", lune_rows, kLunes + 2, 3}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Rays, TwinOfRows,
                         ::testing::Values(Sampling{"N4", ray_row, kLunes, 1},
                                           Sampling{"N16", ray_row, kLunes + 2, 1}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Hemicube, TwinOfPixels,
                         ::testing::Values(Sampling{"R16", hemicube_pixels, &kDelta16, 1},
                                           Sampling{"R32", hemicube_pixels, &kDelta32, 1}),
                         name_of);

TEST(Twin, OfContoursIsWithinTheBarInAnEmptyRoom) {
  TwinRoom room;
  add_room(room, 6);
  Settings settings;
  settings.engine = contour_row;
  expect_within(FixedRun(room.scene(), settings));
}

TEST(Twin, RefusesRowsThatAreCorrectedAfterwards) {
  TwinRoom room;
  add_room(room, 2);
  Settings settings;
  settings.near_field = correct_near_field;
  EXPECT_THROW(Twin(room.scene(), settings), std::invalid_argument);
}

// Six by six elements a face, patches of two by two.
TEST(Twin, ReplaysElementsPatchesAndFacesAndIsLeftWithTheSameUnshotFlux) {
  TwinRoom room;
  add_room(room, 6);
  const FixedRun run(room.scene());
  ASSERT_EQ(run.status, Status::converged);
  std::set<std::size_t> sizes;
  for (const RecordedShot& shot : run.recorder.shots()) {
    sizes.insert(shot.elements.size());
  }
  EXPECT_EQ(sizes, (std::set<std::size_t>{1, 4, 36}));
  const auto twin = run.replay();
  for (int c = 0; c < 3; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    double unshot = 0;
    for (std::size_t e = 0; e < run.scene.element_count; ++e) {
      unshot += twin->unshot(e, channel);
    }
    const auto fixed = static_cast<double>(ledger(run.solver->state(), c).unshot);
    EXPECT_GT(fixed, 0);
    EXPECT_NEAR(unshot / twin->emitted(channel), fixed / twin->emitted(channel), kBar.mean);
  }
}

TEST(Twin, ReplaysABackFaceThatBlocks) {
  TwinRoom room;
  add_room(room, 4);
  const std::uint16_t paint = room.add_material({0.5, 0.5, 0.5}, {0, 0, 0});
  room.add_quad({4000, 3000, 5000}, {5000, 0, 500}, {0, 4000, 300}, 3, paint);
  const FixedRun run(room.scene());
  ASSERT_FALSE(run.solver->state().is_closed);
  const auto twin = run.replay();
  for (unsigned c = 0; c < 3; ++c) {
    const double fixed = run.solver->state().back[c] / twin->emitted(c);
    EXPECT_GT(fixed, 0.01);
    EXPECT_NEAR(twin->back(c) / twin->emitted(c), fixed, kBar.mean);
  }
  expect_within(run);
}

TEST(Twin, ReplaysAnOpenRoomOfOneChannel) {
  TwinRoom room;
  const std::uint16_t wall = room.add_material({0.8, 0, 0}, {0, 0, 0});
  const std::uint16_t lamp = room.add_material({0.2, 0, 0}, {1, 0, 0});
  room.add_quad({2000, 2000, 2000}, {9431, 0, 0}, {0, 8971, 0}, 8, wall);
  room.add_quad({2000, 2000, 2000}, {0, 8971, 0}, {0, 0, 7103}, 8, wall);
  room.add_quad({5903, 6100, 9000}, {0, 3100, 0}, {2900, 0, 0}, 2, lamp);
  const FixedRun run(room.scene(1));
  const auto twin = run.replay();
  const double fixed = run.solver->state().escaped[0] / twin->emitted(0);
  EXPECT_GT(fixed, 0.1);
  EXPECT_NEAR(twin->escaped(0) / twin->emitted(0), fixed, kBar.mean);
  expect_within(run);
}

TEST(Twin, FormFactorsOfEveryShotSumToOne) {
  for (const Sampling& sampling :
       {Sampling{"rows", hemicube_rows, kHemicubes, 2}, Sampling{"pixels", hemicube_pixels, kHemicubes, 2},
        Sampling{"lunes", lune_rows, kLunes + 1, 2}}) {
    TwinRoom room;
    add_room(room, 4);
    add_turned_box(room, 2);
    const FixedRun run(room.scene(), sampling.settings());
    Twin twin(run.scene, run.settings);
    for (const RecordedShot& shot : run.recorder.shots()) {
      twin.shoot(shot, run.recorder.eyes().data() + shot.first_eye);
      const TwinFormFactors& row = twin.form_factors();
      EXPECT_NEAR(std::accumulate(row.share.begin(), row.share.end(), row.escaped + row.back), 1.0, 1e-12);
    }
  }
}

TEST(Twin, LosesNoLightFromAClosedScene) {
  TwinRoom room;
  add_room(room, 4);
  add_turned_box(room, 2);
  const FixedRun run(room.scene());
  ASSERT_TRUE(run.solver->state().is_closed);
  const auto twin = run.replay();
  for (unsigned c = 0; c < 3; ++c) {
    EXPECT_LT(twin->escaped(c) / twin->emitted(c), 1e-9);
    EXPECT_EQ(twin->back(c), 0.0);
  }
}

TEST(Twin, ConservesEnergy) {
  for (const bool overshoot : {false, true}) {
    TwinRoom room;
    add_room(room, 4);
    const std::uint16_t paint = room.add_material({0.5, 0.5, 0.5}, {0, 0, 0});
    room.add_quad({4000, 3000, 5000}, {5000, 0, 500}, {0, 4000, 300}, 3, paint);
    Settings settings;
    settings.overshoot = overshoot;
    const FixedRun run(room.scene(), settings);
    const auto twin = run.replay();
    for (unsigned c = 0; c < 3; ++c) {
      double found = twin->absorbed(c) + twin->escaped(c) + twin->back(c);
      for (std::size_t e = 0; e < run.scene.element_count; ++e) {
        found += twin->unshot(e, c);
      }
      EXPECT_NEAR(found / twin->emitted(c), 1.0, 1e-9);
    }
  }
}

TEST(Twin, RefusesAnEngineThatItDoesNotKnow) {
  TwinRoom room;
  add_room(room, 1);
  Settings settings;
  settings.engine = [](const Scene&, const DeltaTable&, const EyeSample&, Workspace&, FormFactorRow&) {
    return Status::ok;
  };
  EXPECT_THROW(Twin(room.scene(), settings), std::invalid_argument);
}

}  // namespace
}  // namespace fixrad::host

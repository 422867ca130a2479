// SPDX-License-Identifier: MIT
#include "tests/device/box_scene.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

// A lamp (+y) over coloured walls.
constexpr FIXRAD_IN_FLASH Material kLampAndWalls[6] = {
    {{0xc0000000, 0x20000000, 0x80000000}, {0, 0, 0}}, {{0x20000000, 0xc0000000, 0x80000000}, {0, 0, 0}},
    {{0xb3333333, 0xb3333333, 0xb3333333}, {0, 0, 0}}, {{0, 0, 0}, {kEmission, kEmission / 2, kEmission / 3}},
    {{0xe6666666, 0xe6666666, 0xe6666666}, {0, 0, 0}}, {{1, 0x7fffffff, 0xd0000000}, {0, 0, 0}}};

constexpr uint8_t kFaces = 6;

// Shoots until converged or `shots` are done, checking every channel after each.
void expect_balance(BoxSolver& solver, uint16_t shots) {
  const State& state = solver.state();
  Status status = Status::ok;
  while (status == Status::ok && state.shots < shots) {
    for (uint8_t c = 0; c < state.scene.channels; ++c) {
      ASSERT_EQ(ledger(state, c).imbalance(), 0);
    }
    status = solver.step();
  }
  ASSERT_TRUE(status == Status::ok || status == Status::converged);
  EXPECT_GT(state.shots, 6u);
}

TEST(Ledger, OfAClosedBoxBalancesAfterEveryShotAndNothingEscapes) {
  BoxSolver& solver = box_solver();
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces, 3), box_settings()), Status::ok);
  expect_balance(solver, 200);
  for (uint8_t c = 0; c < 3; ++c) {
    const Ledger total = ledger(solver.state(), c);
    EXPECT_EQ(total.escaped, 0);
    EXPECT_EQ(total.back, 0);
    EXPECT_GT(total.absorbed, total.emitted - total.emitted / 100);
  }
}

TEST(Ledger, OfAnOpenBoxBalancesAfterEveryShotAndLightEscapes) {
  BoxSolver& solver = box_solver();
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces - 1, 3), box_settings()), Status::ok);
  expect_balance(solver, 200);
  for (uint8_t c = 0; c < 3; ++c) {
    EXPECT_GT(ledger(solver.state(), c).escaped, 0);
  }
}

TEST(Ledger, BalancesWhileLightIsLent) {
  BoxSolver& solver = box_solver();
  Settings settings = box_settings();
  settings.overshoot = true;
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces, 3), settings), Status::ok);
  expect_balance(solver, 200);
}

TEST(Ledger, BalancesWithSeveralEyesAShot) {
  BoxSolver& solver = box_solver();
  Settings settings = box_settings();
  settings.flux_per_eye = fraction(1, 6);
  settings.tables = &kDelta8;
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces, 3), settings), Status::ok);
  expect_balance(solver, 20);
  EXPECT_GT(solver.state().eyes, solver.state().shots);
}

TEST(Ledger, BalancesWithPixels) {
  BoxSolver& solver = box_solver();
  Settings settings = box_settings();
  settings.engine = hemicube_pixels;
  settings.tables = &kDelta8;
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces, 3), settings), Status::ok);
  expect_balance(solver, 20);
}

TEST(Ledger, BalancesWithLunes) {
  BoxSolver& solver = box_solver();
  Settings settings = box_settings();
  settings.engine = lune_rows;
  settings.tables = settings.probe = kLunes;
  settings.table_count = 3;
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces, 3), settings), Status::ok);
  expect_balance(solver, 200);
  EXPECT_EQ(solver.state().escaped[0], 0);
}

// Slices of every length, some given up, and the ledger of the last complete shot all the while.
TEST(Shot, InSlicesGivesTheBitsOfShotsInOnePiece) {
  BoxSolver& solver = box_solver();
  const State& state = solver.state();
  Settings settings = box_settings();
  settings.flux_per_eye = fraction(1, 6);
  settings.tables = &kDelta8;
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces, 3), settings), Status::ok);
  while (state.shots < 8) {
    ASSERT_EQ(solver.step(), Status::ok);
  }
  int32_t received[kFaces * kElementsPerFace];
  for (uint8_t e = 0; e < kFaces * kElementsPerFace; ++e) {
    received[e] = state.received[e * 3u];
  }
  const uint32_t eyes = state.eyes;
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces, 3), settings), Status::ok);
  for (uint16_t call = 0; state.shots < 8; ++call) {
    const Status status = solver.step(call % 5u + 1u);
    ASSERT_TRUE(status == Status::ok || status == Status::in_progress);
    if (call % 97u == 0) {
      abandon_shot(solver.state());
      ASSERT_EQ(ledger(state, 0).imbalance(), 0);
    }
  }
  EXPECT_EQ(state.eyes, eyes);
  for (uint8_t e = 0; e < kFaces * kElementsPerFace; ++e) {
    EXPECT_EQ(state.received[e * 3u], received[e]);
  }
}

// One shot of each element of the lamp: what arrives is what was sent, and the lamp, which is black, keeps
// nothing.
TEST(Shot, MovesTheWholeEmissionOfAnElement) {
  BoxSolver& solver = box_solver();
  const State& state = solver.state();
  ASSERT_EQ(solver.load(box_scene(kLampAndWalls, kFaces, 3), box_settings()), Status::ok);
  for (uint8_t shots = 1; shots <= kElementsPerFace; ++shots) {
    ASSERT_EQ(solver.step(), Status::ok);
    for (uint8_t c = 0; c < 3; ++c) {
      int64_t received = 0;
      for (uint16_t e = 0; e < state.scene.element_count; ++e) {
        received += state.received[e * 3u + c];
      }
      EXPECT_EQ(received, static_cast<int64_t>(state.emitted[c]) / kElementsPerFace * shots);
    }
  }
  Flux unshot[3];
  EXPECT_EQ(unshot_of(state, face_source(state.scene, 3 * kElementsPerFace), unshot), 0u);
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

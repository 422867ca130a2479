// SPDX-License-Identifier: MIT
// A scene that the host tool has exported, solved here: the same bits.
#include "firmware/scenes/closed_box_tiny.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

namespace box = closed_box_tiny;

// Shared by the tests: two do not fit a small chip.
box::Solver& solver() {
  static box::Solver the_solver;
  return the_solver;
}

void expect_host_solution(const State& state) {
  EXPECT_EQ(digest(state, box::vertex_map()), box::expected::kDigest);
  EXPECT_EQ(state.shots, box::expected::kShots);
  EXPECT_EQ(state.eyes, box::expected::kEyes);
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    const Ledger total = ledger(state, c);
    EXPECT_EQ(total.emitted, box::expected::kLedger[c][0]);
    EXPECT_EQ(total.absorbed, box::expected::kLedger[c][1]);
    EXPECT_EQ(total.unshot, box::expected::kLedger[c][2]);
    EXPECT_EQ(total.escaped, box::expected::kLedger[c][3]);
    EXPECT_EQ(total.back, box::expected::kLedger[c][4]);
  }
}

TEST(ExportedScene, HasTheDigestOfTheHost) {
  ASSERT_EQ(solver().load(box::scene(), box::settings()), Status::ok);
  Status status = Status::ok;
  while (status == Status::ok) {
    status = solver().step();
  }
  ASSERT_EQ(status, Status::converged);
  expect_host_solution(solver().state());
}

// What an application does between two shots: look at the picture so far, with and without the ambient
// estimate.
TEST(ExportedScene, SteppingWithPausesHasTheSameDigest) {
  const VertexMap map = box::vertex_map();
  ASSERT_EQ(solver().load(box::scene(), box::settings()), Status::ok);
  const State& state = solver().state();
  Status status = Status::ok;
  while (status == Status::ok) {
    status = solver().step();
    const uint32_t vertex = state.shots % map.vertex_count;
    ASSERT_LE(solver().vertex_radiosity(map, vertex, 0).raw,
              solver().vertex_radiosity(map, vertex, 0, true).raw);
    ASSERT_EQ(ledger(state, 0).imbalance(), 0);
  }
  expect_host_solution(state);
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

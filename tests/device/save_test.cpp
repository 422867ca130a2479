// SPDX-License-Identifier: MIT
// A solution that is saved and resumed on this target ends in the bits of the host, which never stopped.
#include "firmware/scenes/closed_box_tiny.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

namespace box = closed_box_tiny;

constexpr uint16_t kRoom = saved_bytes(box::Limits::elements, box::Limits::faces, box::Limits::channels);

constexpr uint8_t kShotsBetweenCuts = 30;

// One solver and one place for its state: two solvers do not fit a small chip.
struct Board {
  box::Solver solver;
  uint8_t bytes[kRoom];
  uint16_t count;
};

Board& board() {
  static Board the_board;
  return the_board;
}

bool take(void* context, const uint8_t* bytes, uint8_t count) {
  Board& to = *static_cast<Board*>(context);
  if (count > kRoom - to.count) {
    return false;
  }
  for (uint8_t i = 0; i < count; ++i) {
    to.bytes[to.count++] = bytes[i];
  }
  return true;
}

bool give(void* context, uint32_t offset, uint8_t* bytes, uint8_t count) {
  const Board& from = *static_cast<const Board*>(context);
  if (offset > from.count || from.count - offset < count) {
    return false;
  }
  for (uint8_t i = 0; i < count; ++i) {
    bytes[i] = from.bytes[offset + i];
  }
  return true;
}

// Loads, and takes `shots` shots.
Identity start(Board& b, uint32_t shots) {
  EXPECT_EQ(b.solver.load(box::scene(), box::settings()), Status::ok);
  const Identity identity = b.solver.identify();
  while (b.solver.state().shots < shots) {
    EXPECT_EQ(b.solver.step(), Status::ok);
  }
  return identity;
}

void save(Board& b, const Identity& identity) {
  b.count = 0;
  EXPECT_EQ(b.solver.save(identity, {&b, take}), SaveStatus::ok);
}

void expect_host_solution(const State& state) {
  EXPECT_EQ(digest(state, box::vertex_map()), box::expected::kDigest);
  EXPECT_EQ(state.shots, box::expected::kShots);
  EXPECT_EQ(state.eyes, box::expected::kEyes);
}

// One solution with many power cuts: every time the solver is loaded anew and goes on from what was saved.
TEST(SavedState, ResumedAfterEveryPowerCutEndsInTheDigestOfTheHost) {
  Board& b = board();
  Identity identity = start(b, 0);
  uint16_t cuts = 0;
  Status status = Status::ok;
  while (status == Status::ok) {
    for (uint8_t i = 0; i < kShotsBetweenCuts && status == Status::ok; ++i) {
      status = b.solver.step();
    }
    save(b, identity);
    const uint32_t shots = b.solver.state().shots;
    identity = start(b, 0);
    ASSERT_EQ(b.solver.resume(identity, {&b, give}), SaveStatus::ok);
    ASSERT_EQ(b.solver.state().shots, shots);
    ++cuts;
  }
  ASSERT_EQ(status, Status::converged);
  EXPECT_GT(cuts, 8u);
  EXPECT_EQ(b.solver.step(), Status::converged);
  expect_host_solution(b.solver.state());
}

// One bit of each byte: all bits of all bytes are flipped on the host.
TEST(SavedState, WithAFlippedBitIsRefused) {
  Board& b = board();
  const Identity identity = start(b, 3);
  save(b, identity);
  for (uint16_t i = 0; i < b.count; ++i) {
    const uint8_t bit = static_cast<uint8_t>(1u << (i % 8));
    b.bytes[i] = static_cast<uint8_t>(b.bytes[i] ^ bit);
    ASSERT_NE(b.solver.resume(identity, {&b, give}), SaveStatus::ok);
    b.bytes[i] = static_cast<uint8_t>(b.bytes[i] ^ bit);
  }
  EXPECT_EQ(b.solver.resume(identity, {&b, give}), SaveStatus::ok);
}

TEST(SavedState, ThatEndsEarlyIsTruncated) {
  Board& b = board();
  const Identity identity = start(b, 3);
  save(b, identity);
  while (b.count > 0) {
    b.count = static_cast<uint16_t>(b.count / 2);
    ASSERT_EQ(b.solver.resume(identity, {&b, give}), SaveStatus::truncated);
  }
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

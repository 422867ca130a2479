// SPDX-License-Identifier: MIT
// The one object of fixrad.h: stepping, memory, span pool.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "lib/fixrad.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

using Cornell = Limits<64, 40, 264>;

SolveOptions cornell_options() {
  SolveOptions options;
  options.elements = 264;
  options.settings = settings_with(16, fraction(1, 200));
  return options;
}

TEST(Solver, GivesTheSameBitsAsTheSimulatedDevice) {
  for (const bool overshoot : {false, true}) {
    SolveOptions options = cornell_options();
    options.settings.overshoot = overshoot;
    Solution simulated(cornell(), options);
    ASSERT_EQ(simulated.run(), Status::converged);
    const auto solver = std::make_unique<Solver<Cornell>>();
    Status status = solver->load(simulated.device().view(), options.settings);
    while (status == Status::ok) {
      status = solver->step();
    }
    ASSERT_EQ(status, Status::converged);
    const SurfaceMesh mesh = make_surface_mesh(simulated.prepared(), simulated.device());
    EXPECT_EQ(digest(solver->state(), mesh.map()), simulated.digest());
    EXPECT_EQ(solver->state().shots, simulated.state().shots);
  }
}

TEST(Solver, SteppingWithPausesEqualsAnUninterruptedRun) {
  Solution whole(cornell(), cornell_options());
  ASSERT_EQ(whole.run(), Status::converged);
  const SurfaceMesh mesh = make_surface_mesh(whole.prepared(), whole.device());
  const VertexMap map = mesh.map();
  const auto solver = std::make_unique<Solver<Cornell>>();
  Status status = solver->load(whole.device().view(), cornell_options().settings);
  while (status == Status::ok) {
    status = solver->step();
    for (std::uint32_t v = solver->state().shots % 7; v < map.vertex_count; v += 7) {
      ASSERT_LE(solver->vertex_radiosity(map, v, 1), solver->vertex_radiosity(map, v, 1, true));
    }
    ASSERT_EQ(ledger(solver->state(), 1).imbalance(), 0);
  }
  EXPECT_EQ(digest(solver->state(), map), whole.digest());
}

TEST(Solver, CanLoadAgainAndForgetsTheOldSolution) {
  Solution first(cornell(), cornell_options());
  const auto solver = std::make_unique<Solver<Cornell>>();
  const SurfaceMesh mesh = make_surface_mesh(first.prepared(), first.device());
  const auto run = [&] {
    Status status = solver->load(first.device().view(), cornell_options().settings);
    while (status == Status::ok) {
      status = solver->step();
    }
    return digest(solver->state(), mesh.map());
  };
  const std::uint64_t once = run();
  EXPECT_EQ(run(), once);
}

template <class L>
void expect_documented_size() {
  const Sizes sizes = {L::vertices, L::faces, L::elements, L::spans, L::channels, L::pixel_resolution};
  const std::uint32_t accounts = std::max<std::uint32_t>((L::elements + 1) / 2, L::faces);
  const std::uint32_t arrays = L::vertices * sizeof(Direction) + L::faces * sizeof(FaceView) +
                               L::spans * sizeof(Span) + L::elements * L::channels * sizeof(std::int32_t) +
                               L::elements * sizeof(std::uint32_t) +
                               accounts * L::channels * sizeof(std::int32_t) +
                               L::pixel_resolution * L::pixel_resolution * sizeof(Item);
  EXPECT_EQ(pool_bytes(sizes), arrays);
  constexpr std::uint32_t kAlignment =
      32;  // between the arrays, and the item that a solver without items has
  EXPECT_LE(sizeof(Solver<L>), pool_bytes(sizes) + state_bytes(sizeof(void*)) + kAlignment);
  EXPECT_GE(sizeof(Solver<L>), pool_bytes(sizes));
}

TEST(Memory, IsWhatTheFormulaSays) {
  expect_documented_size<Cornell>();
  expect_documented_size<Limits<8, 6, 6>>();
  expect_documented_size<Limits<8, 6, 11>>();
  expect_documented_size<Limits<28, 20, 263, 41, 1>>();
  expect_documented_size<Limits<100, 77, 999, 55, 3, 32>>();
}

std::uint32_t cornell_ram(std::uint32_t elements, std::size_t& used) {
  SolveOptions options;
  options.elements = elements;
  const Solution solution(cornell(), options);
  used = solution.device().elements.size();
  return ram_bytes(*find_profile("small"), sizes_for(solution.device(), 0, options.settings));
}

TEST(Memory, StateIsWhatTheFormulaSaysButForPadding) {
  constexpr std::uint32_t kPadding = 16;  // of 8-byte pointers; targets have smaller ones
  EXPECT_LE(sizeof(State), state_bytes(sizeof(void*)) + kPadding);
  EXPECT_GE(sizeof(State) + kPadding, state_bytes(sizeof(void*)));
}

TEST(Memory, CornellWith250ElementsTakesAtMost8Kilobytes) {
  std::size_t used = 0;
  const Profile small = *find_profile("small");
  EXPECT_EQ(small.hemicube, 16);
  EXPECT_LE(cornell_ram(small.elements, used), 8192u);
  EXPECT_GE(used, 250u);
}

TEST(Memory, AFurtherElementTakes4BytesAnd6AChannel) {
  const Sizes sizes = {30, 20, 250, 41, 3, 0};
  Sizes more = sizes;
  more.elements += 2;  // two share a word of accounts
  EXPECT_EQ(pool_bytes(more) - pool_bytes(sizes), 2 * (4 + 3 * 6u));
}

TEST(SpanPool, TooSmallIsAStatusAndLeavesTheLedger) {
  SolveOptions options = cornell_options();
  options.spans = 4;
  Solution solution(cornell(), options);
  const Ledger before = ledger(solution.state(), 0);
  ASSERT_EQ(shoot(solution.state()), Status::span_pool_full);
  const Ledger after = ledger(solution.state(), 0);
  EXPECT_EQ(after.unshot, before.unshot);
  EXPECT_EQ(after.absorbed, 0);
  EXPECT_EQ(after.escaped + after.back, 0);
  EXPECT_EQ(solution.state().shots, 0u);
  EXPECT_EQ(shoot(solution.state()), Status::span_pool_full);
}

TEST(SpanPool, OfTwiceTheFacesPlusOneSufficesWhereNothingPierces) {
  for (std::uint32_t seed = 300; seed < 320; ++seed) {
    SolveOptions options;
    options.elements = 60;
    options.settings = settings_with(16, fraction(1, 5));
    Solution solution(random_closed_room(seed), options);
    EXPECT_EQ(solution.run(), Status::converged);
    EXPECT_LE(solution.state().work.span_high_water, 2 * solution.device().faces.size() + 1);
  }
}

TEST(SpanPool, OfTheHighWaterMarkIsEnough) {
  Solution roomy(cornell(), cornell_options());
  ASSERT_EQ(roomy.run(), Status::converged);
  SolveOptions options = cornell_options();
  options.spans = roomy.state().work.span_high_water;
  Solution exact(cornell(), options);
  EXPECT_EQ(exact.run(), Status::converged);
  EXPECT_EQ(exact.digest(), roomy.digest());
}

}  // namespace
}  // namespace fixrad::host

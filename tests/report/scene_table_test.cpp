// SPDX-License-Identifier: MIT
// Exported scenes as a firmware uses them: what a solver makes of the header alone, against what the tool
// found.
#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>

#include "firmware/scenes/cornell_grey_medium.h"
#include "firmware/scenes/cornell_small.h"
#include "firmware/scenes/cornell_tiny.h"
#include "firmware/scenes/portico_tiny.h"
#include "firmware/scenes/white_room_tiny.h"
#include "fresh/3 closed boxes.h"
#include "fresh/cornell_pixels.hpp"
#include "fresh/fixrad.h"

namespace fixrad::host {
namespace {

/// The parts of an exported namespace, since a namespace is no template argument.
#define FIXRAD_EXPORTED(name)                                                                             \
  Exported<name::Solver, std::size(name::expected::kLedger), std::size(name::expected::kReceived)> {      \
    name::scene(), name::vertex_map(), name::settings(), name::expected::kDigest, name::expected::kShots, \
        name::expected::kEyes, name::expected::kLedger, name::expected::kReceived                         \
  }

template <class AnySolver, std::size_t Channels, std::size_t Amounts>
struct Exported {
  using Solver = AnySolver;
  Scene scene;
  VertexMap map;
  Settings settings;
  std::uint64_t digest;
  std::uint32_t shots, eyes;
  const std::int64_t (&ledger)[Channels][5];
  const std::int32_t (&received)[Amounts];
};

template <class AnyExported>
void expect_same_solution(const AnyExported& exported) {
  static typename AnyExported::Solver solver;
  Status status = solver.load(exported.scene, exported.settings);
  while (status == Status::ok) {
    status = solver.step();
  }
  ASSERT_EQ(status, Status::converged);
  const State& state = solver.state();
  EXPECT_EQ(state.shots, exported.shots);
  EXPECT_EQ(state.eyes, exported.eyes);
  ASSERT_EQ(std::size(exported.ledger), state.scene.channels);
  for (std::size_t c = 0; c < std::size(exported.ledger); ++c) {
    const Ledger found = ledger(state, static_cast<int>(c));
    const std::int64_t columns[] = {found.emitted, found.absorbed, found.unshot, found.escaped, found.back};
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_EQ(exported.ledger[c][k], columns[k]) << "channel " << c << ", column " << k;
    }
  }
  ASSERT_EQ(std::size(exported.received), std::size_t{state.scene.element_count} * state.scene.channels);
  for (std::size_t i = 0; i < std::size(exported.received); ++i) {
    ASSERT_EQ(exported.received[i], state.received[i]) << "element " << i / state.scene.channels;
  }
  EXPECT_EQ(digest(state, exported.map), exported.digest);
}

TEST(SceneTable, CommittedScenesGiveTheExpectedSolution) {
  expect_same_solution(FIXRAD_EXPORTED(cornell_tiny));
  expect_same_solution(FIXRAD_EXPORTED(cornell_small));
  expect_same_solution(FIXRAD_EXPORTED(cornell_grey_medium));
  expect_same_solution(FIXRAD_EXPORTED(white_room_tiny));
  expect_same_solution(FIXRAD_EXPORTED(portico_tiny));
}

TEST(SceneTable, FreshlyExportedScenesGiveTheExpectedSolution) {
  expect_same_solution(FIXRAD_EXPORTED(scene_3_closed_boxes));
  expect_same_solution(FIXRAD_EXPORTED(scene_fixrad));
}

TEST(SceneTable, KeepsEngineResolutionAndItemBuffer) {
  EXPECT_TRUE(cornell_pixels::settings().engine == hemicube_pixels);
  EXPECT_EQ(cornell_pixels::settings().tables, &kDelta64);
  EXPECT_EQ(cornell_pixels::settings().table_count, 1);
  EXPECT_EQ(cornell_pixels::Limits::pixel_resolution, 64);
  expect_same_solution(FIXRAD_EXPORTED(cornell_pixels));
}

TEST(SceneTable, KeepsStopEyesAndOvershooting) {
  // The options of the export: --unshot 0.125 --flux-per-eye 0.25 --overshoot; both fractions are exact in
  // binary.
  EXPECT_EQ(scene_fixrad::settings().stop.raw, 1u << 29);
  EXPECT_EQ(scene_fixrad::settings().flux_per_eye.raw, 1u << 30);
  EXPECT_TRUE(scene_fixrad::settings().overshoot);
  EXPECT_FALSE(scene_3_closed_boxes::settings().overshoot);
}

template <class L>
constexpr std::uint32_t solver_ram(std::uint32_t pointer_bytes) {
  return pool_bytes({L::vertices, L::faces, L::elements, L::spans, L::channels, L::pixel_resolution}) +
         state_bytes(pointer_bytes);
}

TEST(SceneTable, CommittedScenesFitTheMemoryOfTheirProfile) {
  EXPECT_LE(solver_ram<cornell_tiny::Limits>(2), 6 * 1024u);
  EXPECT_LE(solver_ram<white_room_tiny::Limits>(2), 6 * 1024u);
  EXPECT_LE(solver_ram<portico_tiny::Limits>(2), 6 * 1024u);
  EXPECT_LE(solver_ram<cornell_small::Limits>(4), 13 * 1024u);
  EXPECT_LE(solver_ram<cornell_grey_medium::Limits>(4), 60 * 1024u);
}

TEST(SceneTable, CommittedScenesAreAsFineAsTheirFiguresClaim) {
  EXPECT_GE(cornell_tiny::scene().element_count, 100);
  EXPECT_GE(cornell_small::scene().element_count, 250);
  EXPECT_GE(portico_tiny::scene().element_count, 60);
}

TEST(SceneTable, TheWhiteRoomReceivesTwentyTimesWhatItsLampEmits) {
  // Reflectance 0.95 everywhere and nothing escapes: absorbed = 0.05 received = emitted - unshot.
  const auto& received = white_room_tiny::expected::kReceived;
  const double sum = std::accumulate(std::begin(received), std::end(received), 0.0);
  const auto& row = white_room_tiny::expected::kLedger[0];
  EXPECT_EQ(row[3], 0);
  EXPECT_EQ(row[4], 0);
  // Splitting each element's total rounds its absorbed part up by less than one unit.
  EXPECT_NEAR(static_cast<double>(row[1]), 0.05 * sum, static_cast<double>(std::size(received)));
  EXPECT_NEAR(sum, 20.0 * static_cast<double>(row[0] - row[2]),
              20.0 * static_cast<double>(std::size(received)));
}

}  // namespace
}  // namespace fixrad::host

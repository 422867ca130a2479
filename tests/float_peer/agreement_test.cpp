// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/float_peer/peer_solution.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

struct Case {
  std::string name;
  Model (*make)();
  std::uint32_t elements, patches;
  bool overshoot;
};

Model closed_room() {
  return random_closed_room(3);
}
Model open_room() {
  return random_open_room(5);
}
Model box_on_floor() {
  return room_with_box(Stand::closed_on_floor, 0.4);
}
Model floating_box() {
  return room_with_box(Stand::floating, 0.4);
}

class PeerAndCore : public testing::TestWithParam<Case> {
 protected:
  static Solution solve() {
    SolveOptions options;
    options.elements = GetParam().elements;
    options.patches = GetParam().patches;
    options.spans = 1000;
    options.settings = peer_settings(fraction(1, 1000));
    options.settings.overshoot = GetParam().overshoot;
    return Solution(GetParam().make(), options);
  }
};

// One run of each for all claims, as solving is what takes time.
TEST_P(PeerAndCore, AgreeInAboutAsManyShotsWithoutLosingLight) {
  // |peer - core| over the mean radiosity: where equal patches come in another order, their eyes are turned
  // by other angles, which moves what R = 32 makes of them.
  constexpr double kMean = 0.012;
  constexpr double kCounts = 0.2;         // shots, eyes
  constexpr double kConservation = 1e-4;  // of the emitted flux, by the rounding of sums in float
  Solution core = solve();
  ASSERT_EQ(core.run(), Status::converged);
  PeerSolution peer(core);
  ASSERT_EQ(peer.run(), Status::converged);
  for (int c = 0; c < core.device().channels; ++c) {
    const Difference difference = relative_difference(peer.radiosities(c), core.radiosities(c));
    RecordProperty("mean_permille_" + std::to_string(c), std::to_string(1000 * difference.mean));
    EXPECT_LT(difference.mean, kMean) << "channel " << c;
  }
  RecordProperty("shots",
                 std::to_string(peer.solver().shots()) + " of " + std::to_string(core.state().shots));
  RecordProperty("eyes", std::to_string(peer.solver().eyes()) + " of " + std::to_string(core.state().eyes));
  EXPECT_NEAR(peer.solver().shots(), core.state().shots, kCounts * core.state().shots);
  EXPECT_NEAR(peer.solver().eyes(), core.state().eyes, kCounts * core.state().eyes);
  EXPECT_LT(peer.imbalance(), kConservation);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PeerAndCore,
                         testing::Values(Case{"Cornell", cornell, 264, 97, false},
                                         Case{"CornellOvershooting", cornell, 264, 264, true},
                                         Case{"CornellCoarse", cornell, 100, 48, false},
                                         Case{"ClosedRoom", closed_room, 300, 100, false},
                                         Case{"OpenRoom", open_room, 300, 100, false},
                                         Case{"BoxOnFloor", box_on_floor, 150, 150, false},
                                         Case{"FloatingBox", floating_box, 150, 150, true}),
                         [](const auto& r) { return r.param.name; });

// The form factors of one shot, before differences could add up: what a lamp lights first.
class PeerFormFactors : public testing::TestWithParam<Case> {};

TEST_P(PeerFormFactors, OfTheFirstShotAreTheCores) {
  constexpr double kLargest = 0.002;  // of the shot's flux, in one element
  SolveOptions options;
  options.settings = peer_settings(fraction(1, 1000));
  Solution core(GetParam().make(), options);
  Peer peer;
  ASSERT_EQ(peer.load(core.device().view(), options.settings), Status::ok);
  ASSERT_EQ(core.run(1), Status::ok);
  ASSERT_EQ(peer.step(), Status::ok);
  ASSERT_EQ(peer.eyes(), core.state().eyes);
  const peer::FormFactorRow& row = peer.state().row;
  const double whole = static_cast<double>(row.whole);
  double sum = 0;
  for (std::uint16_t e = 0; e < core.state().row.count; ++e) {
    const double share = static_cast<double>(row.share[e]) / whole;
    EXPECT_NEAR(share, std::ldexp(core.state().row.share[e], -20), kLargest) << "element " << e;
    sum += share;
  }
  sum += static_cast<double>(row.escaped + row.back) / whole;
  EXPECT_NEAR(sum, 1.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PeerFormFactors,
                         testing::Values(Case{"Cornell", cornell, 0, 0, false},
                                         Case{"ClosedRoom", closed_room, 0, 0, false},
                                         Case{"OpenRoom", open_room, 0, 0, false},
                                         Case{"BoxOnFloor", box_on_floor, 0, 0, false}),
                         [](const auto& r) { return r.param.name; });

TEST(PeerVertices, AreTheCores) {
  constexpr double kMean = 0.005;
  SolveOptions options;
  options.settings = peer_settings(fraction(1, 1000));
  Solution core(cornell(), options);
  ASSERT_EQ(core.run(), Status::converged);
  PeerSolution peer(core);
  ASSERT_EQ(peer.run(), Status::converged);
  const SurfaceMesh mesh = make_surface_mesh(core.prepared(), core.device());
  const VertexMap map = mesh.map();
  std::vector<double> ours, theirs;
  for (std::uint32_t v = 0; v < map.vertex_count; ++v) {
    ours.push_back(static_cast<double>(peer.solver().vertex_radiosity(map, v, 0)));
    theirs.push_back(vertex_radiosity(core.state(), map, v, 0, Radiosity::from_raw(0)).raw);
  }
  ASSERT_GT(ours.size(), 100u);
  EXPECT_LT(relative_difference(ours, theirs).mean, kMean);
}

TEST(PeerLoad, RefusesWhatItHasNoLunesFor) {
  SolveOptions options;
  options.settings = peer_settings(fraction(1, 1000));
  Solution core(cornell(), options);
  Peer peer;
  Settings settings = options.settings;
  settings.table_count = 5;
  EXPECT_EQ(peer.load(core.device().view(), settings), Status::item_buffer_too_small);
  settings = options.settings;
  settings.engine = hemicube_rows;
  EXPECT_EQ(peer.load(core.device().view(), settings), Status::item_buffer_too_small);
  EXPECT_EQ(peer.load(core.device().view(), options.settings), Status::ok);
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// Who shoots when in the float peer, and that nothing is lost where accounts change hands.
#include <gtest/gtest.h>

#include <cstdint>

#include "host_sim/simulate/eye_sights.h"
#include "tests/float_peer/peer_solution.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

struct Case {
  const char* name;
  Model (*make)();
  bool overshoot;
};

Model box_on_floor() {
  return room_with_box(Stand::closed_on_floor, 0.4);
}
Model open_room() {
  return random_open_room(5);
}

// Patches of four elements, as the tool makes them.
Solution core_of(const Case& c) {
  SolveOptions options;
  options.elements = 160;
  options.patches = 40;
  options.spans = 1000;
  options.settings = peer_settings(fraction(1, 1000));
  options.settings.flux_per_row = fraction(1, 2500);  // so that much is left for patches and faces
  options.settings.overshoot = c.overshoot;
  return Solution(c.make(), options);
}

class PeerSources : public testing::TestWithParam<Case> {};

TEST_P(PeerSources, BalanceAfterEveryShot) {
  constexpr double kConservation = 1e-4;  // of the emitted flux, by the rounding of sums in float
  const Solution core = core_of(GetParam());
  PeerSolution peer(core);
  do {
    ASSERT_LT(peer.imbalance(), kConservation) << "after " << peer.state().shots << " shots";
  } while (peer.step() == Status::ok);
}

TEST_P(PeerSources, AreElementsThenPatchesThenFaces) {
  const Solution core = core_of(GetParam());
  PeerSolution peer(core);
  SourceKind kind = SourceKind::element;
  std::uint32_t shots[3] = {};
  Status status = peer.step();
  for (; status == Status::ok; status = peer.step()) {
    const SourceKind now = peer.state().sweep.kind;
    ASSERT_GE(now, kind);
    kind = now;
    ++shots[static_cast<unsigned>(now)];
  }
  EXPECT_EQ(status, Status::converged);
  for (const std::uint32_t of_kind : shots) {
    EXPECT_GT(of_kind, 0u);
  }
}

// No pass has begun while an emitter has its own light still to send.
TEST_P(PeerSources, EmitFirst) {
  const Solution core = core_of(GetParam());
  const DeviceScene& device = core.device();
  std::uint32_t emitters = 0;
  for (const Element& element : device.elements) {
    const auto& emission = device.materials[element.material].emission;
    emitters += emission[0] + emission[1] + emission[2] > 0 ? 1u : 0u;
  }
  PeerSolution peer(core);
  for (std::uint32_t i = 0; i < emitters; ++i) {
    ASSERT_EQ(peer.step(), Status::ok);
    EXPECT_EQ(peer.state().sweep.threshold, 0.0f);
  }
  ASSERT_EQ(peer.step(), Status::ok);
  EXPECT_GT(peer.state().sweep.threshold, 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PeerSources,
                         testing::Values(Case{"Cornell", cornell, false},
                                         Case{"CornellOvershooting", cornell, true},
                                         Case{"BoxOnFloor", box_on_floor, true},
                                         Case{"OpenRoom", open_room, false}),
                         [](const auto& r) { return r.param.name; });

// Sights say what the peer's own probes would find out, so the same eyes are chosen.
TEST(PeerSights, SpareProbesAndChangeNothing) {
  const Solution core = core_of({"", box_on_floor, false});
  const Settings settings = core.state().settings;
  DeviceScene probed = core.device(), known = core.device();
  probed.sights.clear();
  find_sights(known, sizes_for(known, 1000, settings));
  PeerSolution with_probes(probed, settings), with_sights(known, settings);
  ASSERT_EQ(with_probes.run(), Status::converged);
  ASSERT_EQ(with_sights.run(), Status::converged);
  EXPECT_LT(with_sights.state().withdrawn, with_probes.state().withdrawn);
  EXPECT_EQ(with_sights.state().eyes, with_probes.state().eyes);
  EXPECT_EQ(with_sights.radiosities(), with_probes.radiosities());
}

}  // namespace
}  // namespace fixrad::host

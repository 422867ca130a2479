// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/float_peer/peer_solution.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

class PeerFurnace : public testing::TestWithParam<double> {};

// A closed enclosure of one reflectance that emits E everywhere has B = E / (1 - reflectance) everywhere. The
// form factors of R = 16 leave single elements a few per cent off; their mean weighted by area does not see
// that.
TEST_P(PeerFurnace, ReachesTheClosedForm) {
  constexpr double kBar = 0.005;
  const double reflectance = GetParam();
  SolveOptions options;
  options.settings = peer_settings(fraction(1, 10000));
  const Solution core(cube(reflectance, {1, 1, 1, 1, 1, 1}), options);
  PeerSolution peer(core);
  ASSERT_EQ(peer.run(), Status::converged);
  double flux = 0, area = 0;
  const std::vector<double> radiosities = peer.radiosities();
  for (std::size_t e = 0; e < radiosities.size(); ++e) {
    flux += radiosities[e] * core.device().elements[e].area;
    area += core.device().elements[e].area;
  }
  EXPECT_NEAR(flux / area * (1 - reflectance), 1.0, kBar);
  EXPECT_LT(peer.imbalance(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Reflectance, PeerFurnace, testing::Values(0.5, 0.9), [](const auto& r) {
  return "Permille" + std::to_string(std::lround(1000 * r.param));
});

// In a closed room nothing escapes; what rounding leaves open between two faces is far below the flux of an
// eye.
TEST(PeerClosedRoom, LosesNoLightThroughItsEdges) {
  constexpr float kLeak = 1e-5f;  // of the emitted flux
  SolveOptions options;
  options.settings = peer_settings(fraction(1, 1000));
  const Solution core(cube(0.8, {1, 0, 0, 0, 0, 0}), options);
  PeerSolution peer(core);
  ASSERT_EQ(peer.run(), Status::converged);
  EXPECT_LT(peer.state().escaped.c[0], kLeak * peer.state().emitted.c[0]);
  EXPECT_EQ(peer.state().back.c[0], 0.0f);
}

}  // namespace
}  // namespace fixrad::host

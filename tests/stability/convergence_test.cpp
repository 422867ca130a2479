// SPDX-License-Identifier: MIT
// Shooting comes nearer with every shot, and the ledger says for free how near.
#include "host_sim/simulate/convergence.h"

#include <gtest/gtest.h>

#include "tests/lib/scenes.h"
#include "tests/stability/bound_trial.h"

namespace fixrad::host {
namespace {

struct Variant {
  const char* name;
  Engine engine;
  bool overshoot;
};

class ConvergenceOf : public testing::TestWithParam<Variant> {
 protected:
  static SolveOptions options() {
    SolveOptions options;
    options.elements = 80;
    options.settings = GetParam().engine == lune_rows ? lune_settings(16, fraction(1, 1000))
                                                      : settings_with(8, fraction(1, 1000));
    options.settings.overshoot = GetParam().overshoot;
    return options;
  }
};

// Proven without overshooting, for rows that are sampled anew for every shot; measured with it.
TEST_P(ConvergenceOf, TheErrorBoundHoldsAfterEveryShot) {
  for (const BoundScene& scene : bound_scenes()) {
    const BoundTrial trial = try_bound(scene.model, options());
    EXPECT_LE(trial.worst, 1.0) << scene.name;
    EXPECT_GT(trial.moments, 10u) << scene.name;
  }
}

// A shot takes a units from its source, and of a units that arrive no more than a are reflected.
TEST_P(ConvergenceOf, UnshotFluxNeverGrowsWithoutOvershooting) {
  for (const auto& [name, model] : bound_scenes()) {
    SolveOptions plain = options();
    plain.settings.overshoot = false;
    Solution solution(model, plain);
    const State& state = solution.state();
    std::uint64_t before[kMaxChannels] = {~std::uint64_t{0}, ~std::uint64_t{0}, ~std::uint64_t{0}};
    do {
      for (int c = 0; c < state.scene.channels; ++c) {
        const std::uint64_t now = sum_unshot(state, c).magnitude;
        ASSERT_LE(now, before[c]) << name << " shot " << state.shots << " channel " << c;
        before[c] = now;
      }
    } while (shoot(solution.state()) == Status::ok);
  }
}

INSTANTIATE_TEST_SUITE_P(Engine, ConvergenceOf,
                         testing::Values(Variant{"Lunes", lune_rows, false},
                                         Variant{"LunesOvershooting", lune_rows, true},
                                         Variant{"Rows", hemicube_rows, false}),
                         [](const auto& variant) { return variant.param.name; });

// In a closed room of one reflectance every unit that is unshot will be received 1 / (1 - reflectance) times:
// the bound is what happens, to within the unit an element that rounding may take.
TEST(ErrorBound, IsTightInAClosedRoomOfOneReflectance) {
  SolveOptions options;
  options.elements = 60;
  options.settings = lune_settings(16, fraction(1, 100));
  Solution solution(cube(0.8, {1, 0, 0, 0, 0, 0}), options);
  ASSERT_EQ(solution.run(), Status::converged);
  State& state = solution.state();
  const ErrorBound bound = error_bounds(state)[0];
  const std::vector<std::int32_t> stopped = received_flux_of(state);
  shoot_on(state, Fraction::from_raw(0));
  const double distance = flux_distance(stopped, received_flux_of(state), 0, 1).distance;
  const double rounding = 2 * state.scene.element_count / (1 - bound.largest_reflectance);
  EXPECT_LE(distance, bound.flux);
  EXPECT_GE(distance, bound.flux - rounding);
}

}  // namespace
}  // namespace fixrad::host

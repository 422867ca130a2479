// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

// B = E / (1 - rho) with E = 1, rho = 0.5.
constexpr double kFurnace = 2.0;

TEST(Bake, FurnaceIsEquallyBrightEverywhere) {
  const auto scene = sample("closed_box");
  const BakeResult result = bake(scene->prepared, on_profile("medium"));
  ASSERT_EQ(result.element_radiosity.size(), result.plan.sizes.elements);
  double flux = 0, area = 0;
  for (std::size_t e = 0; e < result.element_radiosity.size(); ++e) {
    // Where two walls meet, rows of samples meet the near elements only now and then.
    EXPECT_NEAR(result.element_radiosity[e].x, kFurnace, 0.04 * kFurnace) << "element " << e;
    area += result.device.mesh.elements[e].area;
    flux += result.element_radiosity[e].x * result.device.mesh.elements[e].area;
  }
  EXPECT_NEAR(flux / area, kFurnace, 0.005 * kFurnace);
  ASSERT_EQ(result.vertex_radiosity.size(), result.surface.positions.size());
  // Extrapolation to a border doubles what the elements there are off.
  for (const glm::dvec3& b : result.vertex_radiosity) {
    EXPECT_NEAR(b.x, kFurnace, 0.06 * kFurnace);
  }
}

TEST(Bake, StopsWhenProgressSaysSoWithABalancedLedger) {
  const auto scene = sample("high_rho");
  BakeOptions options = on_profile("host");
  options.unshot = 1e-6;
  const BakeResult result = bake(scene->prepared, options, [](auto...) { return false; });
  EXPECT_TRUE(result.interrupted);
  EXPECT_GT(result.unshot_fraction, 1e-6);
  ASSERT_EQ(result.ledger.size(), 1u);
  const Ledger& l = result.ledger[0];
  EXPECT_EQ(l.emitted, l.absorbed + l.unshot + l.escaped + l.back);
}

TEST(Bake, ProgressSeesTheUnshotFluxFall) {
  const auto scene = sample("cornell");
  double last = 1;
  int calls = 0;
  const auto watch = [&](std::uint32_t, double unshot, double seconds) {
    EXPECT_LT(unshot, 1.0);
    EXPECT_GT(seconds, 0.0);
    last = unshot;
    ++calls;
    return true;
  };
  const BakeResult result = bake(scene->prepared, on_profile("large"), watch);
  EXPECT_FALSE(result.interrupted);
  EXPECT_GT(calls, 0);
  EXPECT_LE(result.unshot_fraction, 0.001);
  EXPECT_GE(last, result.unshot_fraction);
}

TEST(Bake, ObserversDoNotChangeTheResult) {
  const auto scene = sample("cornell");
  const BakeOptions options = on_profile("small");
  const BakeResult plain = bake(scene->prepared, options);
  const BakeResult watched = bake(scene->prepared, options, [](auto...) { return true; });
  EXPECT_EQ(plain.digest, watched.digest);
  EXPECT_EQ(plain.shots, watched.shots);
}

}  // namespace
}  // namespace fixrad::host::testing

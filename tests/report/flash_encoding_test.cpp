// SPDX-License-Identifier: MIT
#include "host_sim/report/flash_encoding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fixrad::host {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

TEST(Rgbe8, EncodesPowersOfTwoExactly) {
  // 1 = 128 * 2^(129 - 136), 0.5 = 64 * 2^(129 - 136).
  EXPECT_EQ(rgbe8({1.0, 0.5, 0.0}), (Rgbe{128, 64, 0, 129}));
  EXPECT_EQ(rgbe8({2.0, 2.0, 2.0}), (Rgbe{128, 128, 128, 130}));
}

TEST(Rgbe8, TakesTheNextExponentWhereAMantissaWouldRoundTo256) {
  EXPECT_EQ(rgbe8({0.999, 0.0, 0.0}), (Rgbe{128, 0, 0, 129}));
}

TEST(Rgbe8, IsBlackForBlackAndForLessThanItHolds) {
  EXPECT_EQ(rgbe8({0.0, 0.0, 0.0}), (Rgbe{0, 0, 0, 0}));
  EXPECT_EQ(rgbe8({1e-60, 0.0, 0.0}), (Rgbe{0, 0, 0, 0}));
}

TEST(Rgbe8, SaturatesAboveItsRange) {
  EXPECT_EQ(rgbe8({1e60, 0.0, 0.0}), (Rgbe{255, 0, 0, 255}));
}

TEST(Rgbe8, ErrsByHalfAStepAtMost) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> decades(-6.0, 6.0);
  for (int n = 0; n < 10000; ++n) {
    const glm::dvec3 b(std::pow(10.0, decades(random)), std::pow(10.0, decades(random)), 1e-3);
    const Rgbe code = rgbe8(b);
    const double step = std::ldexp(1.0, code[3] - kRgbeBias);
    for (int k = 0; k < 3; ++k) {
      ASSERT_LE(std::abs(code[static_cast<std::size_t>(k)] * step - b[k]), 0.5 * step);
    }
    ASSERT_LE(0.5 * step, std::max({b.x, b.y, b.z}) / 255.0);
  }
}

TEST(PositionGrid, HoldsEveryPositionWithinHalfAStep) {
  const std::vector<glm::dvec3> positions = {{-100.3, 7.0, 0.0}, {250.7, 7.1, 0.0}, {0.123456, 7.05, 0.0}};
  const PositionGrid grid = position_grid(positions);
  EXPECT_NEAR(grid.scale, 351.0 / 2.0 / 32767.0, 1e-6);
  for (const glm::dvec3& position : positions) {
    const auto q = quantise(grid, position);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(grid.offset[k] + q[static_cast<std::size_t>(k)] * grid.scale - position[k]),
                0.5 * grid.scale);
    }
  }
}

TEST(PositionGrid, OfASinglePointIsThatPoint) {
  const PositionGrid grid = position_grid({{3.0, 4.0, 5.0}});
  EXPECT_EQ(grid.offset, glm::dvec3(3.0, 4.0, 5.0));
  EXPECT_GT(grid.scale, 0.0);
}

TEST(NamespaceName, IsAnIdentifierWithoutReservedUnderscores) {
  EXPECT_EQ(namespace_name("cornell"), "cornell");
  EXPECT_EQ(namespace_name("Living Room (2)"), "Living_Room_2");
  EXPECT_EQ(namespace_name("__a--b__"), "a_b");
  EXPECT_EQ(namespace_name("caf\xc3\xa9"), "caf");
}

TEST(NamespaceName, AvoidsNamesThatMeanSomething) {
  EXPECT_EQ(namespace_name(""), "scene");
  EXPECT_EQ(namespace_name("\xe6\x88\xbf"), "scene");
  EXPECT_EQ(namespace_name("3rd floor"), "scene_3rd_floor");
  EXPECT_EQ(namespace_name("new"), "scene_new");
  EXPECT_EQ(namespace_name("std"), "scene_std");
  EXPECT_EQ(namespace_name("int8_t"), "scene_int8_t");
}

}  // namespace
}  // namespace fixrad::host

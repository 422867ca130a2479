// SPDX-License-Identifier: MIT
#include "firmware/float_peer/lune_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace fixrad::peer {
namespace {

double running_sum(double s) {
  return (std::atan(s) + s / (1 + s * s)) / std::acos(-1.0);
}

TEST(PeerLuneSum, IsTheClosedFormOnBothSidesOfTheMiddle) {
  constexpr double kLine = 1.5e-4;  // of a row, by straight lines between entries
  for (float s = 1e-3f; s < 200.0f; s *= 1.003f) {
    EXPECT_NEAR(lune_sum(s), running_sum(static_cast<double>(s)), kLine) << s;
    EXPECT_EQ(lune_sum(-s), -lune_sum(s)) << s;
  }
}

TEST(PeerLuneSum, NeverFallsAndEndsAtHalfARow) {
  float before = lune_sum(0.0f);
  EXPECT_EQ(before, 0.0f);
  for (float s = 1e-3f; s < 200.0f; s *= 1.0007f) {
    const float sum = lune_sum(s);
    EXPECT_GE(sum, before - 1e-7f) << s;
    before = sum;
  }
  EXPECT_EQ(before, 0.5f);
}

class PeerLunes : public testing::TestWithParam<int> {};

// Sines of the angles are equally spaced, so all lunes weigh the same.
TEST_P(PeerLunes, AreEquallySpacedInTheSine) {
  const LuneTable table = lune_table(static_cast<std::uint8_t>(GetParam()));
  const int size = 1 << GetParam();
  ASSERT_EQ(table.size, size);
  for (int r = 0; r < size; ++r) {
    const LuneRow row = lune_row(table, static_cast<std::uint8_t>(r));
    const double sine = (2.0 * r + 1) / size - 1;
    EXPECT_NEAR(row.cosine, std::sqrt(1 - sine * sine), 1e-7) << r;
    EXPECT_NEAR(row.y * row.cosine, sine, 1e-6) << r;
  }
}

INSTANTIATE_TEST_SUITE_P(ResolutionLog2, PeerLunes, testing::Values(2, 3, 4, 5),
                         [](const auto& r) { return "K" + std::to_string(r.param); });

}  // namespace
}  // namespace fixrad::peer

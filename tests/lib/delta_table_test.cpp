// SPDX-License-Identifier: MIT
#include "lib/form_factor/delta_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/simulate/profile.h"
#include "host_sim/tables/delta_form_factors.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr long kOne = 1L << 20;

class DeltaTables : public testing::TestWithParam<int> {
 protected:
  const DeltaTable& table() const { return *delta_table(GetParam()); }
  int half() const { return GetParam() / 2; }
  std::uint16_t top(int row, int i) const { return flash_read(table().top, index(row, i)); }
  std::uint16_t side(int row, int i) const { return flash_read(table().side, index(row, i)); }

 private:
  unsigned index(int row, int i) const { return static_cast<unsigned>(row * half() + i); }
};

TEST_P(DeltaTables, AreWhatTheirProgramComputes) {
  const DeltaTableData data = make_delta_table(GetParam());
  for (int r = 0; r < half(); ++r) {
    for (int i = 0; i < half(); ++i) {
      const auto at = static_cast<std::size_t>(r * half() + i);
      ASSERT_EQ(top(r, i), data.top[at]);
      ASSERT_EQ(side(r, i), data.side[at]);
    }
  }
  EXPECT_EQ(1 << table().resolution_log2, GetParam());
}

// Cohen & Greenberg 1985, the density at a pixel's centre times its area; the entry is the integral, so they
// differ by the curvature, at most about 2 / R^2, and by one unit of rounding, more where a row was moved.
TEST_P(DeltaTables, PixelsAgreeWithTheClassicalFormula) {
  const double size = 2.0 / GetParam();
  for (int r = 0; r < half(); ++r) {
    for (int i = 0; i < half(); ++i) {
      const double x = (i + 0.5) * size, y = (r + 0.5) * size;
      const double s = x * x + y * y + 1;
      const double density = size * size / (kPi * s * s) * kOne;
      const double slack = 2 + 4.0 / (GetParam() * GetParam()) * density;
      ASSERT_NEAR(top(r, i) - (i == 0 ? 0 : top(r, i - 1)), density, slack);
      ASSERT_NEAR(side(r, i) - (i == 0 ? 0 : side(r, i - 1)), density * y, slack);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Resolution, DeltaTables, testing::Values(8, 16, 32, 64, 128),
                         [](const auto& table) { return "R" + std::to_string(table.param); });

TEST(DeltaTable, OnlyTheFiveResolutionsExist) {
  EXPECT_EQ(delta_table(4), nullptr);
  EXPECT_EQ(delta_table(24), nullptr);
  EXPECT_EQ(delta_table(256), nullptr);
}

}  // namespace
}  // namespace fixrad::host

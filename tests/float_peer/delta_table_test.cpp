// SPDX-License-Identifier: MIT
#include "firmware/float_peer/delta_table.h"

#include <gtest/gtest.h>

#include "host_sim/simulate/profile.h"
#include "lib/form_factor/delta_table.h"

namespace fixrad::host {
namespace {

class PeerDeltaTable : public testing::TestWithParam<int> {};

// At the borders of pixels both tables hold the same integers.
TEST_P(PeerDeltaTable, IsTheCoresAtEveryPixelBorder) {
  const fixrad::DeltaTable& core = *delta_table(GetParam());
  const peer::DeltaTable ours = peer::delta_table(core.resolution_log2);
  const int half = GetParam() / 2;
  ASSERT_EQ(ours.half, half);
  for (const bool is_top : {true, false}) {
    for (int r = is_top ? 0 : half; r < 2 * half; ++r) {
      const peer::DeltaRow row = peer::delta_row(ours, is_top, static_cast<std::uint8_t>(r));
      const fixrad::DeltaRow expected = fixrad::delta_row(core, is_top, r);
      for (int x = 0; x <= half; ++x) {
        const std::uint32_t end = expected.sum_to(kRowMiddle + x * (kRowMiddle / half));
        const auto sum = static_cast<float>(end - expected.half_total);
        EXPECT_EQ(row.sum_to(static_cast<float>(x)), sum) << "row " << r << " x " << x;
        EXPECT_EQ(row.sum_to(static_cast<float>(-x)), -sum) << "row " << r << " x " << -x;
      }
    }
  }
}

TEST_P(PeerDeltaTable, IsContinuousAndRisesWithinPixels) {
  const peer::DeltaTable table = peer::delta_table(delta_table(GetParam())->resolution_log2);
  for (std::uint8_t r = 0; r < 2 * table.half; ++r) {
    const peer::DeltaRow row = peer::delta_row(table, true, r);
    const float end = table.half;
    float before = row.sum_to(-end);
    for (float x = -end + 0.125f; x <= end; x += 0.125f) {
      const float sum = row.sum_to(x);
      EXPECT_GT(sum, before);
      before = sum;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Resolution, PeerDeltaTable, testing::Values(8, 16, 32),
                         [](const auto& r) { return "R" + std::to_string(r.param); });

}  // namespace
}  // namespace fixrad::host

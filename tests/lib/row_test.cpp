// SPDX-License-Identifier: MIT
#include "lib/form_factor/row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "lib/form_factor/delta_table.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kHemicube = 1u << kDeltaSumLog2;

struct TestRow {
  explicit TestRow(std::size_t count)
      : share(count, 0), row{share.data(), static_cast<std::uint16_t>(count), 0, 0} {}

  std::uint32_t sum() const {
    return std::accumulate(share.begin(), share.end(), std::uint32_t{0}) + row.escaped + row.back;
  }

  std::vector<std::uint32_t> share;
  FormFactorRow row;
};

std::uint16_t random_slot(Random& random, int count) {
  const int slot = random.between(0, count + 1);
  return slot < count ? static_cast<std::uint16_t>(slot) : (slot == count ? kEscapedSlot : kBackSlot);
}

TEST(RowWriter, GivesExactlyTheWeightOfEachEye) {
  Random random(1);
  for (int round = 0; round < 500; ++round) {
    TestRow test(7);
    std::uint32_t begin = 0;
    while (begin < kRowOne) {
      const std::uint32_t weight =
          std::min(kRowOne - begin, static_cast<std::uint32_t>(random.between(1, 500000)));
      RowWriter writer(test.row, begin, weight);
      for (std::uint32_t sum = 0; sum < kHemicube;) {
        sum = std::min(kHemicube, sum + static_cast<std::uint32_t>(random.between(0, 60000)));
        writer.add(random_slot(random, 7), sum);
      }
      begin += weight;
      ASSERT_EQ(test.sum(), begin);
    }
  }
}

TEST(RowWriter, DoesNotDependOnHowAnIntervalIsCut) {
  TestRow whole(3), cut(3);
  RowWriter one(whole.row, 0, kRowOne), many(cut.row, 0, kRowOne);
  one.add(0, 300001);
  one.add(1, kHemicube);
  for (std::uint32_t sum = 0; sum < 300001; sum += 7) {
    many.add(0, sum);
  }
  many.add(0, 300001);
  many.add(1, kHemicube);
  EXPECT_EQ(whole.share, cut.share);
}

TEST(RowWriter, HoldsTheWholeHemisphereInOneElement) {
  for (const std::uint16_t slot : {std::uint16_t{0}, std::uint16_t{2}}) {
    TestRow test(3);
    RowWriter(test.row, 0, kRowOne).add(slot, kHemicube);
    EXPECT_EQ(test.share[slot], kRowOne);
    EXPECT_EQ(test.row.escaped + test.row.back, 0u);
  }
}

TEST(RowWriter, RoundsToNearest) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    TestRow test(1);
    const auto weight = static_cast<std::uint32_t>(random.between(1, static_cast<int>(kRowOne)));
    const std::uint32_t sum = random.bits() >> 12;
    RowWriter(test.row, 0, weight).add(0, sum);
    ASSERT_LE(std::abs(test.share[0] - static_cast<double>(sum) * weight / kHemicube), 0.5);
  }
}

}  // namespace
}  // namespace fixrad::host

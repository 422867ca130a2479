// SPDX-License-Identifier: MIT
#include "lib/form_factor/row.h"

#include "lib/form_factor/delta_table.h"
#include "tests/device/random.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

constexpr uint32_t kHemicube = static_cast<uint32_t>(1) << kDeltaSumLog2;

uint32_t at_most(uint32_t limit, uint32_t value) {
  return value < limit ? value : limit;
}

template <uint16_t Count>
struct TestRow {
  uint32_t share[Count] = {};
  FormFactorRow row = {share, Count, 0, 0};

  uint32_t sum() const {
    uint32_t total = row.escaped + row.back;
    for (const uint32_t s : share) {
      total += s;
    }
    return total;
  }
};

uint16_t random_slot(Random& random, uint16_t count) {
  const uint16_t slot = static_cast<uint16_t>(random.between(0, count + 1u));
  return slot < count ? slot : (slot == count ? kEscapedSlot : kBackSlot);
}

TEST(RowWriter, GivesExactlyTheWeightOfEachEye) {
  Random random(1);
  for (uint16_t round = 0; round < 50; ++round) {
    TestRow<7> test;
    for (uint32_t begin = 0; begin < kRowOne;) {
      const uint32_t weight = at_most(kRowOne - begin, random.between(1, 500000));
      RowWriter writer(test.row, weight);
      for (uint32_t sum = 0; sum < kHemicube;) {
        sum = at_most(kHemicube, sum + random.between(0, 60000));
        writer.add(random_slot(random, 7), sum);
      }
      begin += weight;
      ASSERT_EQ(test.sum(), begin);
    }
  }
}

TEST(RowWriter, DoesNotDependOnHowAnIntervalIsCut) {
  TestRow<3> whole;
  TestRow<3> cut;
  RowWriter one(whole.row, kRowOne);
  RowWriter many(cut.row, kRowOne);
  one.add(0, 300001);
  one.add(1, kHemicube);
  for (uint32_t sum = 0; sum < 300001; sum += 7) {
    many.add(0, sum);
  }
  many.add(0, 300001);
  many.add(1, kHemicube);
  for (uint8_t j = 0; j < 3; ++j) {
    EXPECT_EQ(whole.share[j], cut.share[j]);
  }
}

TEST(RowWriter, HoldsTheWholeHemisphereInOneElement) {
  for (uint8_t slot = 0; slot < 3; ++slot) {
    TestRow<3> test;
    RowWriter(test.row, kRowOne).add(slot, kHemicube);
    EXPECT_EQ(test.share[slot], kRowOne);
    EXPECT_EQ(test.row.escaped + test.row.back, 0u);
  }
}

// |share 2^20 - sum weight| <= 2^19, that is within half a unit of sum weight / 2^20.
TEST(RowWriter, RoundsToNearest) {
  Random random(2);
  for (uint16_t i = 0; i < 3000; ++i) {
    TestRow<1> test;
    const uint32_t weight = random.between(1, kRowOne);
    const uint32_t sum = random.bits() >> 12;
    RowWriter(test.row, weight).add(0, sum);
    const int64_t exact = static_cast<int64_t>(sum) * weight;
    const int64_t difference = static_cast<int64_t>(test.share[0]) * static_cast<int64_t>(kHemicube) - exact;
    ASSERT_LE(difference < 0 ? -difference : difference, static_cast<int64_t>(kHemicube / 2));
  }
}

TEST(FormFactorRow, IsEmptyAfterClear) {
  TestRow<4> test;
  RowWriter(test.row, kRowOne).add(2, kHemicube);
  test.row.back = test.row.escaped = 5;
  clear(test.row);
  EXPECT_EQ(test.sum(), 0u);
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

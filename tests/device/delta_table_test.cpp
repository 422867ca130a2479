// SPDX-License-Identifier: MIT
#include "lib/form_factor/delta_table.h"

#include "lib/form_factor/row.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

void expect_sum_one(const FIXRAD_FLASH DeltaTable& in_flash, uint8_t resolution) {
  const DeltaTable table = flash_read(&in_flash, 0);
  ASSERT_EQ(1 << table.resolution_log2, resolution + 0);
  uint32_t sum = 0;
  for (uint8_t r = 0; r < resolution; ++r) {
    sum += delta_row(table, true, r).sum_to(kRowEnd);
  }
  for (uint8_t r = resolution / 2; r < resolution; ++r) {
    sum += 4 * delta_row(table, false, r).sum_to(kRowEnd);
  }
  EXPECT_EQ(sum, kRowOne);
}

void expect_rising(const FIXRAD_FLASH DeltaTable& in_flash, uint8_t resolution) {
  const DeltaTable table = flash_read(&in_flash, 0);
  const uint16_t half = resolution / 2;
  for (uint16_t r = 0; r < half; ++r) {
    for (uint16_t i = 1; i < half; ++i) {
      const uint16_t at = static_cast<uint16_t>(r * half + i);
      ASSERT_LE(flash_read(table.top, at - 1u), flash_read(table.top, at));
      ASSERT_LE(flash_read(table.side, at - 1u), flash_read(table.side, at));
    }
  }
}

void expect_running(const FIXRAD_FLASH DeltaTable& in_flash) {
  const DeltaTable table = flash_read(&in_flash, 0);
  const DeltaRow row = delta_row(table, true, 0);
  EXPECT_EQ(row.sum_to(0), 0u);
  EXPECT_EQ(row.sum_to(kRowMiddle), row.half_total);
  EXPECT_EQ(row.sum_to(kRowEnd), 2 * row.half_total);
  for (int16_t x = 1; x <= kRowEnd; ++x) {
    ASSERT_LE(row.sum_to(x - 1), row.sum_to(x));
    ASSERT_EQ(row.sum_to(x) + row.sum_to(kRowEnd - x), 2 * row.half_total);
  }
}

void expect_lune_sum_one(const FIXRAD_FLASH DeltaTable& in_flash, uint8_t resolution) {
  const DeltaTable table = flash_read(&in_flash, 0);
  ASSERT_EQ(1 << table.resolution_log2, resolution + 0);
  uint32_t sum = 0;
  for (uint8_t r = 0; r < resolution; ++r) {
    sum += delta_row(table, true, r).sum_to(kRowEnd);
  }
  EXPECT_EQ(sum, kRowOne);
}

TEST(DeltaTable, OfLunesSumsToExactlyOneOverTheHemisphere) {
  for (uint8_t i = 0; i < kLuneTables; ++i) {
    expect_lune_sum_one(kLunes[i], static_cast<uint8_t>(4 << i));
  }
}

TEST(DeltaTable, SumsToExactlyOneOverTheHemicube) {
  expect_sum_one(kDelta8, 8);
  expect_sum_one(kDelta16, 16);
  expect_sum_one(kDelta32, 32);
  expect_sum_one(kDelta64, 64);
  expect_sum_one(kDelta128, 128);
}

TEST(DeltaTable, NeverFallsAlongARow) {
  expect_rising(kDelta8, 8);
  expect_rising(kDelta16, 16);
  expect_rising(kDelta32, 32);
  expect_rising(kDelta64, 64);
  expect_rising(kDelta128, 128);
}

TEST(DeltaTable, RunsFromZeroToTheWholeRow) {
  expect_running(kDelta8);
  expect_running(kDelta16);
  expect_running(kDelta32);
  expect_running(kDelta64);
  expect_running(kDelta128);
  for (uint8_t i = 0; i < kLuneTables; ++i) {
    expect_running(kLunes[i]);
  }
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

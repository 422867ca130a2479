// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "host_sim/report/tone.h"
#include "lib/picture/tone.h"

namespace fixrad::host {
namespace {

void expect_near(const std::uint16_t (&light)[3], int most) {
  const glm::dvec3 exposed(light[0] / 4096.0, light[1] / 4096.0, light[2] / 4096.0);
  const Srgb8 expected = display_colour(exposed, 1.0);
  std::uint8_t pixel[3];
  display_pixel(light, 3, pixel);
  for (std::size_t c = 0; c < 3; ++c) {
    ASSERT_LE(std::abs(pixel[c] - expected[c]), most) << light[0] << ' ' << light[1] << ' ' << light[2];
  }
}

TEST(ToneTable, ShowsEveryGreyWithinOneCodeOfTheCurveInDouble) {
  for (unsigned light = 0; light <= kLightMax; ++light) {
    const auto value = static_cast<std::uint16_t>(light);
    expect_near({value, value, value}, 1);
    std::uint8_t grey;
    display_pixel(&value, 1, &grey);
    std::uint8_t pixel[3];
    const std::uint16_t all[3] = {value, value, value};
    display_pixel(all, 3, pixel);
    ASSERT_EQ(grey, pixel[0]);
  }
}

TEST(ToneTable, ShowsColoursWithinTwoCodes) {
  std::mt19937 random(4);
  for (int i = 0; i < 200000; ++i) {
    const auto channel = [&] { return static_cast<std::uint16_t>((random() & 0xffff) >> (random() % 12)); };
    const std::uint16_t light[3] = {channel(), channel(), channel()};
    expect_near(light, 2);
  }
}

TEST(ToneTable, ShowsMoreLightAtMostOneCodeDarker) {
  int brightest = 0;
  for (unsigned light = 0; light <= kLightMax; ++light) {
    const auto value = static_cast<std::uint16_t>(light);
    std::uint8_t grey;
    display_pixel(&value, 1, &grey);
    ASSERT_GE(grey + 1, brightest) << light;
    brightest = std::max<int>(brightest, grey);
  }
  EXPECT_EQ(brightest, 255);
}

TEST(ToneTable, ExposesWithoutOverflow) {
  const Exposure exposure = {0x80000000u, 33};
  EXPECT_EQ(expose(exposure, Radiosity::from_raw(4000)), 1000);
  EXPECT_EQ(expose(exposure, Radiosity::from_raw(0xffffffffu)), kLightMax);
}

}  // namespace
}  // namespace fixrad::host

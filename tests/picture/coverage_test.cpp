// SPDX-License-Identifier: MIT
#include "lib/picture/coverage.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

namespace fixrad {
namespace {

using Pixels = std::map<std::pair<int, int>, int>;  // how often each is taken

void add(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c, int height, int width,
         Pixels& pixels) {
  Coverage(a, b, c).rows(0, height, width, [&](int32_t y, int32_t from, int32_t to) {
    for (int32_t x = from; x < to; ++x) {
      ++pixels[{x, y}];
    }
  });
}

// Whether the pixel's centre lies on the inner side of from -> to, whose triangle runs clockwise on the
// screen; on the edge itself: whether the edge is a left or a top one.
bool is_inside(const ScreenCorner& from, const ScreenCorner& to, int x, int y) {
  const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
  const std::int64_t side = dx * (256 * y + 128 - from.y) - dy * (256 * x + 128 - from.x);
  const bool is_top_left = dy < 0 || (dy == 0 && dx > 0);
  return side > 0 || (side == 0 && is_top_left);
}

TEST(Coverage, TakesExactlyThePixelsOfTheTopLeftRule) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 400; ++trial) {
    // Every other triangle has corners on pixel centres, so that edges run through centres.
    const int step = trial % 2 == 0 ? 1 : 128;
    const auto corner = [&] {
      const auto coordinate = [&] { return static_cast<int>(random() % (24 * 256)) / step * step - 512; };
      return ScreenCorner{coordinate(), coordinate(), 1};
    };
    ScreenCorner a = corner(), b = corner(), c = corner();
    if (screen_area(a, b, c) == 0) {
      continue;
    }
    if (screen_area(a, b, c) < 0) {
      std::swap(b, c);
    }
    Pixels expected, taken;
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        if (is_inside(a, b, x, y) && is_inside(b, c, x, y) && is_inside(c, a, x, y)) {
          expected[{x, y}] = 1;
        }
      }
    }
    add(a, b, c, 20, 20, taken);
    ASSERT_EQ(taken, expected) << "trial " << trial;
    Pixels turned;
    add(c, b, a, 20, 20, turned);
    EXPECT_EQ(turned, expected) << "the sense of the corners does not matter";
  }
}

TEST(Coverage, TrianglesRoundAVertexTakeEachPixelOnce) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const auto inner = [&] { return static_cast<int>(random() % 5000) - 200; };
    const ScreenCorner middle = {inner(), inner(), 1};
    const ScreenCorner round[] = {{-9000, -9000, 1}, {3000, -9500, 1}, {9000, -9000, 1},
                                  {9000, 9000, 1},   {-800, 9100, 1},  {-9000, 9000, 1}};
    Pixels taken;
    for (std::size_t i = 0; i < 6; ++i) {
      add(middle, round[i], round[(i + 1) % 6], 18, 18, taken);
    }
    ASSERT_EQ(taken.size(), 18u * 18u);
    for (const auto& [pixel, times] : taken) {
      ASSERT_EQ(times, 1) << pixel.first << ' ' << pixel.second;
    }
  }
}

}  // namespace
}  // namespace fixrad

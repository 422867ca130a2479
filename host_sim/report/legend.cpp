// SPDX-License-Identifier: MIT
#include "host_sim/report/legend.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "host_sim/report/error_map.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

constexpr int kBarTop = 8, kBarHeight = 14, kTickHeight = 4;
constexpr int kMargin = 60;     // left and right of the bar, for half of a text
constexpr int kScale = 2;       // pixels a dot of a glyph
constexpr int kGlyphWidth = 6;  // dots, with the gap
constexpr int kMarks = 5;
constexpr std::uint8_t kInk = 230, kPaper = 40;

// A glyph of 5 x 7 dots: a row of five bits each, the leftmost first.
struct Glyph {
  char character;
  std::uint8_t rows[7];
};
constexpr Glyph kGlyphs[] = {
    {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},  {'2', {14, 17, 1, 2, 4, 8, 31}},
    {'3', {31, 2, 4, 2, 1, 17, 14}},     {'4', {2, 6, 10, 18, 31, 2, 2}}, {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},   {'8', {14, 17, 17, 14, 17, 17, 14}},
    {'9', {14, 17, 17, 15, 1, 2, 12}},   {'.', {0, 0, 0, 0, 0, 12, 12}},  {'%', {24, 25, 2, 4, 8, 19, 3}},
    {'+', {0, 4, 4, 31, 4, 4, 0}},       {'-', {0, 0, 0, 31, 0, 0, 0}}};

class Canvas {
 public:
  explicit Canvas(Image& image) : image_(image) {}

  void set(int x, int y, const std::array<std::uint8_t, 3>& colour) {
    if (x >= 0 && x < image_.width && y >= 0 && y < image_.height) {
      std::copy(colour.begin(), colour.end(),
                image_.rgb.begin() + 3 * (std::ptrdiff_t{y} * image_.width + x));
    }
  }

  // Centred on x.
  void write(const std::string& text, int x, int y) {
    x -= (static_cast<int>(text.size()) * kGlyphWidth - 1) * kScale / 2;
    for (const char character : text) {
      const auto* glyph = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                       [&](const Glyph& g) { return g.character == character; });
      for (int dot = 0; glyph != std::end(kGlyphs) && dot < 35 * kScale * kScale; ++dot) {
        const int column = dot % (5 * kScale), row = dot / (5 * kScale);
        if ((glyph->rows[row / kScale] >> (4 - column / kScale) & 1) != 0) {
          set(x + column, y + row, {kInk, kInk, kInk});
        }
      }
      x += kGlyphWidth * kScale;
    }
  }

 private:
  Image& image_;
};

std::string percent(double error) {
  std::string text = error > 0 ? "+" : "";
  append_number(text, std::round(1e4 * error) / 100);
  return text + "%";
}

// One row of pixels from -limit to +limit.
ErrorMap scale_map(int width, double limit) {
  ErrorMap map{width, 1, {}};
  const int samples = width * kErrorSamples;
  for (int i = 0; i < kErrorSamples * samples; ++i) {
    map.errors.push_back(limit * (2 * (i % samples + 0.5) / samples - 1));
  }
  return map;
}

}  // namespace

Image with_legend(const Image& picture, double limit) {
  Image image = picture;
  image.height += kLegendHeight;
  image.rgb.resize(image.rgb.size() + static_cast<std::size_t>(3 * kLegendHeight * image.width), kPaper);
  Canvas canvas(image);
  const int left = std::min(kMargin, image.width / 4), right = image.width - left;
  const Image colours = false_colours(scale_map(right - left, limit), limit);
  for (int x = left; x < right; ++x) {
    const auto at = static_cast<std::size_t>(3 * (x - left));
    for (int y = 0; y < kBarHeight; ++y) {
      canvas.set(x, picture.height + kBarTop + y,
                 {colours.rgb[at], colours.rgb[at + 1], colours.rgb[at + 2]});
    }
  }
  for (int mark = 0; mark < kMarks; ++mark) {
    const int x = left + (right - 1 - left) * mark / (kMarks - 1);
    for (int y = 0; y < kTickHeight; ++y) {
      canvas.set(x, picture.height + kBarTop + kBarHeight + y, {kInk, kInk, kInk});
    }
    canvas.write(percent(limit * (2.0 * mark / (kMarks - 1) - 1)), x,
                 picture.height + kBarTop + kBarHeight + kTickHeight + 3);
  }
  return image;
}

}  // namespace fixrad::host

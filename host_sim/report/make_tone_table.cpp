// SPDX-License-Identifier: MIT
// Writes the core's tone curve, from the one in double:
//
//     make_tone_table > lib/picture/tone_table.cpp
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/report/tone.h"
#include "lib/picture/tone.h"

namespace fixrad::host {
namespace {

constexpr double kFirst = 0.25;
constexpr int kPerOctave = 16;

int rounded(double value, int one) {
  return static_cast<int>(std::min(std::lround(value * one), 65535L));
}

void print_curve() {
  std::printf("const FIXRAD_IN_FLASH TonePoint kToneCurve[kTonePoints] = {\n");
  for (int i = 0; i < kTonePoints; ++i) {
    const double octave = std::exp2(i / kPerOctave);
    const double peak = kFirst * octave * (1 + static_cast<double>(i % kPerOctave) / kPerOctave);
    const glm::dvec3 shown = tone({peak, 0, 0});
    std::printf("%s{%d, %d},%s", i % 8 == 0 ? "    " : " ", rounded((shown.x - shown.y) / peak, 1 << 15),
                rounded(shown.y, 1 << 16), i % 8 == 7 ? "\n" : "");
  }
  std::printf("\n};\n\n");
}

void print_thresholds() {
  std::printf("const FIXRAD_IN_FLASH uint16_t kSrgbThresholds[kSrgbSteps] = {\n");
  int linear = 0;
  for (int code = 1; code <= kSrgbSteps; ++code) {
    while (std::lround(255 * srgb_from_linear(linear / 65536.0)) < code) {
      ++linear;
    }
    std::printf("%s%d,%s", code % 16 == 1 ? "    " : " ", linear, code % 16 == 0 ? "\n" : "");
  }
  std::printf("\n};\n\n");
}

}  // namespace
}  // namespace fixrad::host

int main() {
  std::printf(
      "// SPDX-License-Identifier: MIT\n"
      "// clang-format off\n"
      "// Made by host_sim/report/make_tone_table.cpp; do not edit.\n"
      "#include \"lib/picture/tone.h\"\n\n"
      "namespace fixrad {\n\n");
  fixrad::host::print_curve();
  fixrad::host::print_thresholds();
  std::printf("}  // namespace fixrad\n");
}

// SPDX-License-Identifier: MIT
// Prints lune_table.cpp from the closed forms:  make_peer_lune_table > firmware/float_peer/lune_table.cpp
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

#include "firmware/float_peer/lune_table.h"

namespace {

double running_sum(double s) {
  return (std::atan(s) + s / (1 + s * s)) / std::acos(-1.0);
}

void print_pair(unsigned index, double a, double b) {
  std::printf("%s{%.9ef, %.9ef},", index % 3 == 0 ? "\n    " : " ", a, b);
}

void print_lunes() {
  std::printf("constexpr FIXRAD_IN_FLASH Lune kLunes[] = {");
  for (const unsigned size : {4u, 8u, 16u, 32u}) {
    std::printf("\n    // R = %u", size);
    for (unsigned i = 0; i < size / 2; ++i) {
      const double sine = (2.0 * i + 1) / size;
      const double cosine = std::sqrt(1 - sine * sine);
      print_pair(i, sine / cosine, cosine);
    }
  }
  std::printf("\n};\n\n");
}

void print_segments() {
  std::printf("constexpr FIXRAD_IN_FLASH Segment kSegments[] = {");
  for (unsigned i = 0; i < fixrad::peer::kSegmentCount; ++i) {
    const double octave = std::exp2(static_cast<double>(i / 16) - 5);
    const double begin = octave * (1 + i % 16 / 16.0), end = octave * (1 + (i % 16 + 1) / 16.0);
    const bool is_last = i + 1 == fixrad::peer::kSegmentCount;
    const double sum = running_sum(begin);
    const double slope = ((is_last ? 0.5 : running_sum(end)) - sum) / (end - begin);
    print_pair(i, sum - slope * begin, slope);
  }
  std::printf("\n};\n\n");
}

}  // namespace

int main() {
  std::printf(
      "// SPDX-License-Identifier: MIT\n// Made by firmware/float_peer/make_lune_table.cpp; do not edit.\n"
      "// clang-format off\n#include \"firmware/float_peer/lune_table.h\"\n\nnamespace fixrad {\nnamespace "
      "peer {\nnamespace {\n\n");
  print_lunes();
  print_segments();
  std::printf(
      "}  // namespace\n\nconst FIXRAD_FLASH Lune* all_lunes() {\n  return kLunes;\n}\n\n"
      "const FIXRAD_FLASH Segment* lune_segments() {\n  return kSegments;\n}\n\n"
      "}  // namespace peer\n}  // namespace fixrad\n");
  return 0;
}

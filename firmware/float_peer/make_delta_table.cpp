// SPDX-License-Identifier: MIT
// Prints delta_table.cpp from the core's tables:  make_peer_delta_table > firmware/float_peer/delta_table.cpp
#include <cstdint>
#include <cstdio>
#include <initializer_list>

#include "lib/form_factor/delta_table.h"

namespace {

void print_segments(const char* name, int half, const std::uint16_t* sums) {
  std::printf("\n    // R = %d, %s", 2 * half, name);
  for (int i = 0; i < half * half; ++i) {
    const int pixel = i % half;
    const int below = pixel == 0 ? 0 : sums[i - 1];
    const int slope = sums[i] - below;
    std::printf("%s{%d, %d},", i % 6 == 0 ? "\n    " : " ", below - slope * pixel, slope);
  }
}

}  // namespace

int main() {
  std::printf(
      "// SPDX-License-Identifier: MIT\n// Made by firmware/float_peer/make_delta_table.cpp; do not edit.\n"
      "// clang-format off\n#include \"firmware/float_peer/delta_table.h\"\n\nnamespace fixrad {\nnamespace "
      "peer {\n"
      "namespace {\n\n"
      "constexpr FIXRAD_PEER_TABLE Segment kSegments[] = {");
  for (const FIXRAD_FLASH fixrad::DeltaTable* table :
       {&fixrad::kDelta8, &fixrad::kDelta16, &fixrad::kDelta32}) {
    const int half = 1 << (table->resolution_log2 - 1);
    print_segments("top", half, table->top);
    print_segments("side", half, table->side);
  }
  std::printf(
      "\n};\n\n}  // namespace\n\nconst FIXRAD_FLASH Segment* delta_segments() {\n  return kSegments;\n}\n\n"
      "}  // namespace peer\n}  // namespace fixrad\n");
  return 0;
}

// SPDX-License-Identifier: MIT
// Prints lib/form_factor/delta_table_<R>.cpp:  make_delta_tables R > lib/form_factor/delta_table_R.cpp
#include <cstdio>
#include <cstdlib>

#include "host_sim/tables/delta_form_factors.h"

namespace {

void print_table(const char* name, const std::vector<std::uint16_t>& values) {
  std::printf("constexpr FIXRAD_FLASH uint16_t %s[] = {", name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::printf("%s%u,", i % 16 == 0 ? "\n    " : " ", static_cast<unsigned>(values[i]));
  }
  std::printf("\n};\n\n");
}

int log2_of(int n) {
  int k = 0;
  while ((1 << k) < n) {
    ++k;
  }
  return k;
}

}  // namespace

int main(int argc, char** argv) {
  const int resolution = argc == 2 ? std::atoi(argv[1]) : 0;
  const int k = log2_of(resolution);
  if (k < 3 || k > 7 || (1 << k) != resolution) {
    std::fprintf(stderr, "usage: make_delta_tables 8|16|32|64|128\n");
    return 2;
  }
  const fixrad::host::DeltaTableData data = fixrad::host::make_delta_table(resolution);
  std::printf(
      "// SPDX-License-Identifier: MIT\n// Made by host_sim/tables/make_delta_tables.cpp; do not edit.\n");
  std::printf(
      "// clang-format off\n#include \"lib/form_factor/delta_table.h\"\n\nnamespace fixrad {\nnamespace "
      "{\n\n");
  print_table("kTop", data.top);
  print_table("kSide", data.side);
  std::printf("}  // namespace\n\nconst DeltaTable kDelta%d = {%d, kTop, kSide};\n\n}  // namespace fixrad\n",
              resolution, k);
  return 0;
}

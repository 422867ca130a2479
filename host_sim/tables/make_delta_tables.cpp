// SPDX-License-Identifier: MIT
// Prints the core's tables:  make_delta_tables R > lib/form_factor/delta_table_R.cpp
//                           make_delta_tables lunes > lib/form_factor/lune_tables.cpp
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "host_sim/tables/delta_form_factors.h"

namespace {

void print_head() {
  std::printf(
      "// SPDX-License-Identifier: MIT\n// Made by host_sim/tables/make_delta_tables.cpp; do not edit.\n"
      "// clang-format off\n#include \"lib/form_factor/delta_table.h\"\n\nnamespace fixrad {\nnamespace "
      "{\n\n");
}

template <class T>
void print_table(const char* type, const std::string& name, const std::vector<T>& values) {
  std::printf("constexpr FIXRAD_IN_FLASH %s %s[] = {", type, name.c_str());
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

void print_hemicube(int resolution) {
  const fixrad::host::DeltaTableData data = fixrad::host::make_delta_table(resolution);
  print_head();
  print_table("uint16_t", "kTop", data.top);
  print_table("uint16_t", "kSide", data.side);
  std::printf(
      "}  // namespace\n\nconst FIXRAD_IN_FLASH DeltaTable kDelta%d = {%d, kTop, kSide, nullptr};\n\n",
      resolution, log2_of(resolution));
  std::printf("}  // namespace fixrad\n");
}

void print_lunes() {
  print_head();
  print_table("uint16_t", "kHalfRow", fixrad::host::make_lune_half_row());
  for (int k = 2; k <= 7; ++k) {
    print_table("int16_t", "kCosine" + std::to_string(1 << k), fixrad::host::make_lune_cosines(1 << k));
  }
  std::printf("}  // namespace\n\n");
  std::printf("const FIXRAD_IN_FLASH DeltaTable kLunes[kLuneTables] = {\n");
  for (int k = 2; k <= 7; ++k) {
    std::printf("    {%d, kHalfRow, nullptr, kCosine%d},\n", k, 1 << k);
  }
  std::printf("};\n\n}  // namespace fixrad\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "lunes") == 0) {
    print_lunes();
    return 0;
  }
  const int resolution = argc == 2 ? std::atoi(argv[1]) : 0;
  const int k = log2_of(resolution);
  if (k < 3 || k > 7 || (1 << k) != resolution) {
    std::fprintf(stderr, "usage: make_delta_tables 8|16|32|64|128|lunes\n");
    return 2;
  }
  print_hemicube(resolution);
  return 0;
}

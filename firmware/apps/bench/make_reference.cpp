// SPDX-License-Identifier: MIT
// Solves a scene of `bench` in double and prints a header with the radiosities of its elements:
//     make_bench_reference cornell_small > firmware/apps/bench/reference/cornell_small.h
// Two solutions. `same_shots`: the shots and eye points of the core's run, in double; against it the core
// has the error of its arithmetic alone. `fine`: every element by itself with as many eye points as the core
// can use and 128 rows in each, in double; against it everything counts that a run with the scene's own
// settings leaves out.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "firmware/scenes/cornell_small.h"
#include "firmware/scenes/cornell_tiny.h"
#include "host_sim/reference/twin.h"
#include "host_sim/simulate/simulated_device.h"

namespace fixrad::host {
namespace {

// Radiosities in the core's unit, [element][channel].
using Radiosities = std::vector<double>;

Radiosities solve_in_double(const Scene& scene, Settings settings, const Sizes& sizes) {
  SimulatedDevice device(sizes);
  Recorder recorder(device.state());
  settings.observer = recorder.observer();
  Status status = device.load(scene, settings);
  while (status == Status::ok) {
    status = shoot(device.state());
  }
  if (status != Status::converged) {
    std::fprintf(stderr, "make_bench_reference: %s\n", describe(status));
    std::exit(1);
  }
  Twin twin(scene, settings);
  twin.replay(recorder);
  Radiosities all;
  for (std::size_t e = 0; e < scene.element_count; ++e) {
    for (std::size_t c = 0; c < scene.channels; ++c) {
      all.push_back(std::ldexp(twin.exitent_flux(e, c), scene.radiosity_shift) / scene.elements[e].area);
    }
  }
  return all;
}

Settings fine(Settings settings) {
  settings.tables = &kLunes[kLuneTables - 1];
  settings.table_count = 1;
  settings.probe = &kLunes[3];
  settings.flux_per_row = fraction(1, 1000000);
  settings.flux_per_eye = fraction(1, 100000);
  settings.stop = fraction(1, 10000);
  return settings;
}

void print_table(const char* name, const Radiosities& values) {
  std::printf("constexpr FIXRAD_IN_FLASH float %s[] = {", name);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::printf("%s%.5ef,", i % 8 == 0 ? "\n    " : " ", values[i]);
  }
  std::printf("\n};\n");
}

template <class Limits>
void print_scene(const char* name, const Scene& scene, const Settings& settings) {
  constexpr std::uint32_t kSpans = 1000;
  const Sizes sizes = {Limits::vertices, Limits::faces, Limits::elements, kSpans, Limits::channels, 0};
  std::printf(
      "// SPDX-License-Identifier: MIT\n// clang-format off\n"
      "// Made by firmware/apps/bench/make_reference.cpp; do not edit.\n"
      "// Radiosities of the elements in the core's unit, solved in double, [element][channel].\n"
      "#pragma once\n\n#include \"lib/fixed/flash.h\"\n\nnamespace %s {\nnamespace in_double {\n\n",
      name);
  std::printf("// The core's own shots and eye points.\n");
  print_table("kSameShots", solve_in_double(scene, settings, sizes));
  std::printf("\n// More eye points, 128 rows in each.\n");
  print_table("kFine", solve_in_double(scene, fine(settings), sizes));
  std::printf("\n}  // namespace in_double\n}  // namespace %s\n", name);
}

}  // namespace
}  // namespace fixrad::host

// The scene `name` of its header, where `asked` is its name.
#define FIXRAD_REFERENCE(name, asked)                                                \
  if (std::strcmp(asked, #name) == 0) {                                              \
    fixrad::host::print_scene<name::Limits>(#name, name::scene(), name::settings()); \
    return 0;                                                                        \
  }                                                                                  \
  static_assert(true, "a semicolon may follow")

int main(int argc, char** argv) {
  if (argc == 2) {
    FIXRAD_REFERENCE(cornell_tiny, argv[1]);
    FIXRAD_REFERENCE(cornell_small, argv[1]);
  }
  std::fprintf(stderr, "usage: make_bench_reference cornell_tiny|cornell_small\n");
  return 2;
}

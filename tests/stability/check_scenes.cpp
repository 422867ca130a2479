// SPDX-License-Identifier: MIT
// Properties of random scenes, as many as one likes; failures are made small and printed.
//   check_scenes [--count N] [--first-seed N] [--property NAME]
//   check_scenes --list
// Exit code 1 if a scene fails.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "tests/stability/properties.h"

namespace {

std::uint64_t closed_rooms(std::uint64_t first, std::uint64_t count) {
  std::uint64_t closed = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    closed += fixrad::host::random_scene(seed).is_closed ? 1 : 0;
  }
  return closed;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace fixrad::host;
  constexpr std::size_t kMostFailures = 5;
  std::uint64_t count = 1000, first = 0;
  std::string only;
  CLI::App app("Check properties of random scenes");
  app.add_option("--count", count, "scenes");
  app.add_option("--first-seed", first, "seed of the first; the others follow");
  app.add_option("--property", only, "check this one alone");
  bool is_list = false;
  app.add_flag("--list", is_list,
               "name all properties, each with its theory behind a tab, and check nothing");
  CLI11_PARSE(app, argc, argv);
  if (is_list) {
    for (const Property& property : properties()) {
      std::printf("%s\t%s\n", property.name.c_str(), property.theory.c_str());
    }
    return 0;
  }
  bool is_good = true, is_any = false;
  for (const Property& property : properties()) {
    if (!only.empty() && property.name != only) {
      continue;
    }
    is_any = true;
    const std::vector<Failure> failures = check_scenes(property, first, count, kMostFailures);
    std::printf("%s: seeds %llu to %llu, %llu of them closed rooms: %s\n", property.name.c_str(),
                static_cast<unsigned long long>(first), static_cast<unsigned long long>(first + count - 1),
                static_cast<unsigned long long>(closed_rooms(first, count)),
                failures.empty() ? "all keep to it" : "FAILED");
    for (const Failure& failure : failures) {
      std::printf("%s\n", report(failure, property).c_str());
    }
    std::fflush(stdout);
    is_good = is_good && failures.empty();
  }
  if (!is_any) {
    std::fprintf(stderr, "check_scenes: no property %s\n", only.c_str());
  }
  return is_any ? (is_good ? 0 : 1) : 2;
}

// SPDX-License-Identifier: MIT
// Solves every scene of firmware/scenes on the host and compares all bits with those committed. Exit code 0
// if all are equal.
#include "all_scenes.h"
#include "firmware/apps/report.h"
#include "firmware/apps/text.h"
#include "firmware/boards/board.h"

namespace fixrad {
namespace board {

// Asked for by the report on a chip; a host's stack is not measured.
uint32_t stack_used() {
  return 0;
}

uint32_t stack_size() {
  return 1;
}

}  // namespace board
}  // namespace fixrad

namespace {

template <class Solver>
bool gives_the_bits(const fixrad::Scene& scene, const fixrad::Settings& settings,
                    const fixrad::VertexMap& map, const fixrad::ExpectedSolution& expected) {
  static Solver solver;
  fixrad::Status status = solver.load(scene, settings);
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  const fixrad::Difference difference =
      fixrad::compare(solver.state(), fixrad::digest(solver.state(), map), expected);
  fixrad::report::write_difference(difference);
  return status == fixrad::Status::converged && difference.what == fixrad::Disagreement::none;
}

}  // namespace

// A line for the list that the build makes of the folder.
#define FIXRAD_SOLVE(name)                                                                                  \
  fixrad::text::write_line("scene", #name);                                                                 \
  equal +=                                                                                                  \
      gives_the_bits<name::Solver>(name::scene(), name::settings(), name::vertex_map(),                     \
                                   {name::expected::kDigest, name::expected::kShots, name::expected::kEyes, \
                                    name::expected::kLedger, name::expected::kReceived})                    \
          ? 1u                                                                                              \
          : 0u;                                                                                             \
  ++scenes;

int main() {
  uint32_t equal = 0, scenes = 0;
  FIXRAD_ALL_SCENES(FIXRAD_SOLVE)
  fixrad::text::write(equal);
  fixrad::text::write(" of ");
  fixrad::text::write(scenes);
  fixrad::text::write(" scenes equal\n");
  return equal == scenes ? 0 : 1;
}

// SPDX-License-Identifier: MIT
// Solves the scene FIXRAD_SCENE, compiled into flash, to convergence, prints the solution's figures, and
// compares every bit with what the host has computed. Exit code 0 if all agree and the stack kept to its
// place.
//
// With FIXRAD_FLIP_A_BIT the lowest bit of one received flux is flipped before the comparison, which must
// find it.

#include <stdint.h>

#include FIXRAD_SCENE_HEADER
#include "firmware/apps/report.h"
#include "firmware/apps/text.h"
#include "firmware/regions.h"

#define FIXRAD_TEXT_OF(name) #name
#define FIXRAD_TEXT(name) FIXRAD_TEXT_OF(name)

FIXRAD_REGION(load);
FIXRAD_REGION(solve);
FIXRAD_REGION(vertices);
FIXRAD_REGION(end);

namespace baked = FIXRAD_SCENE;

namespace {

baked::Solver solver;

fixrad::Status solve() {
  fixrad_region_load();
  fixrad::Status status = solver.load(baked::scene(), baked::settings());
  fixrad_region_solve();
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  return status;
}

uint64_t digest() {
  fixrad_region_vertices();
  const uint64_t value = fixrad::digest(solver.state(), baked::vertex_map());
  fixrad_region_end();
  return value;
}

fixrad::Difference compare(uint64_t digest) {
  namespace expected = baked::expected;
  return fixrad::compare(
      solver.state(), digest,
      {expected::kDigest, expected::kShots, expected::kEyes, expected::kLedger, expected::kReceived});
}

}  // namespace

int main() {
  fixrad::text::write_line("scene", FIXRAD_TEXT(FIXRAD_SCENE));
  const fixrad::Status status = solve();
#ifdef FIXRAD_FLIP_A_BIT
  solver.state().received[solver.state().scene.element_count / 2 * solver.state().scene.channels] ^= 1;
#endif
  const uint64_t value = digest();
  fixrad::report::write_solution(solver.state(), status, value, sizeof solver);
  const bool stack_fits = fixrad::report::write_stack();
  const fixrad::Difference difference = compare(value);
  fixrad::report::write_difference(difference);
  const bool is_equal = status == fixrad::Status::converged && difference.what == fixrad::Disagreement::none;
  return is_equal && stack_fits ? 0 : 1;
}

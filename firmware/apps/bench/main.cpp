// SPDX-License-Identifier: MIT
// Solves the scene FIXRAD_SCENE between regions, for the emulator's counters; prints what was computed, so
// that nobody counts a solver that gives something else. Each way of computing that is measured side by side
// has a function of its own here, with regions of its own, called one after the other by main().

#include <stdint.h>

#include FIXRAD_SCENE_HEADER
#include "firmware/apps/report.h"
#include "firmware/regions.h"

FIXRAD_REGION(load);
FIXRAD_REGION(solve);
FIXRAD_REGION(vertices);
FIXRAD_REGION(end);

namespace baked = FIXRAD_SCENE;

namespace {

baked::Solver solver;

// The core. Returns whether the digest is the expected one.
bool run_fixed() {
  fixrad_region_load();
  fixrad::Status status = solver.load(baked::scene(), baked::settings());
  fixrad_region_solve();
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  fixrad_region_vertices();
  const uint64_t digest = fixrad::digest(solver.state(), baked::vertex_map());
  fixrad_region_end();
  fixrad::report::write_solution(solver.state(), status, digest, sizeof solver);
  return status == fixrad::Status::converged && digest == baked::expected::kDigest;
}

}  // namespace

int main() {
  const bool fixed_is_right = run_fixed();
  const bool stack_fits = fixrad::report::write_stack();
  return fixed_is_right && stack_fits ? 0 : 1;
}

// SPDX-License-Identifier: MIT
// Solves the scene FIXRAD_SCENE with the core, then with the float peer in the same memory, each between
// regions of its own for the emulator's counters; prints what was computed, so that nobody counts a solver
// that gives something else.

#include <stddef.h>
#include <stdint.h>

#include FIXRAD_SCENE_HEADER
#include FIXRAD_REFERENCE_HEADER
#include "firmware/apps/bench/radiosity_error.h"
#include "firmware/apps/report.h"
#include "firmware/apps/text.h"
#include "firmware/boards/board.h"
#include "firmware/float_peer/solver.h"
#include "firmware/regions.h"

FIXRAD_REGION(load);
FIXRAD_REGION(core_solve);
FIXRAD_REGION(vertices);
FIXRAD_REGION(peer_load);
FIXRAD_REGION(peer_solve);
FIXRAD_REGION(peer_vertices);
FIXRAD_REGION(report);

namespace baked = FIXRAD_SCENE;

namespace {

// May be made where something else was.
struct Peer : fixrad::peer::Solver<baked::Limits> {
  static void* operator new(size_t, void* where) { return where; }
};

union Memory {
  Memory() : core() {}
  baked::Solver core;
  Peer peer;
} memory;

// Mean and largest error of the elements' radiosities, in millionths of the scene's mean.
template <class Of>
void write_errors(const char* solver, const Of& radiosity) {
  const fixrad::Scene scene = baked::scene();
  const struct {
    const char* name;
    const FIXRAD_FLASH float* radiosities;
  } references[] = {{"same_shots", baked::in_double::kSameShots}, {"fine", baked::in_double::kFine}};
  for (const auto& reference : references) {
    const fixrad::RadiosityError error = fixrad::radiosity_error(scene, reference.radiosities, radiosity);
    fixrad::text::write(solver);
    fixrad::text::write("_error_ppm ");
    fixrad::text::write(reference.name);
    fixrad::text::write(" mean ");
    fixrad::text::write(error.mean);
    fixrad::text::write(" largest ");
    fixrad::text::write(error.largest);
    fixrad::text::write("\n");
  }
}

struct CoreRadiosity {
  float operator()(uint16_t element, uint8_t channel) const {
    return static_cast<float>(
        fixrad::element_radiosity(memory.core.state(), element, channel, fixrad::Radiosity::from_raw(0)).raw);
  }
};

struct PeerRadiosity {
  float operator()(uint16_t element, uint8_t channel) const {
    return memory.peer.element_radiosity(element, channel);
  }
};

// Returns whether the digest is the expected one.
bool run_core() {
  baked::Solver& solver = memory.core;
  fixrad_region_load();
  fixrad::Status status = solver.load(baked::scene(), baked::settings());
  fixrad_region_core_solve();
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  fixrad_region_vertices();
  const uint64_t digest = fixrad::digest(solver.state(), baked::vertex_map());
  fixrad_region_report();
  fixrad::report::write_solution(solver.state(), status, digest, sizeof solver);
  write_errors("core", CoreRadiosity());
  return status == fixrad::Status::converged && digest == baked::expected::kDigest;
}

// The sum of all vertex radiosities, so that nothing of them can be left out.
float sum_of_vertices(const Peer& solver) {
  const fixrad::VertexMap map = baked::vertex_map();
  float sum = 0.0f;
  for (uint32_t v = 0; v < map.vertex_count; ++v) {
    for (uint8_t c = 0; c < solver.state().scene.channels; ++c) {
      sum += solver.vertex_radiosity(map, v, c);
    }
  }
  return sum;
}

// Returns whether it converged to something.
bool run_peer() {
  Peer& solver = *new (&memory.peer) Peer;
  fixrad_region_peer_load();
  fixrad::Status status = solver.load(baked::scene(), baked::settings());
  fixrad_region_peer_solve();
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  fixrad_region_peer_vertices();
  const float sum = sum_of_vertices(solver);
  fixrad_region_report();
  fixrad::text::write_line("peer_status", status == fixrad::Status::converged ? "converged" : "failed");
  fixrad::text::write_line("peer_shots", solver.shots());
  fixrad::text::write_line("peer_eyes", solver.eyes());
  fixrad::text::write_line("peer_bytes", static_cast<uint32_t>(sizeof solver));
  write_errors("peer", PeerRadiosity());
  return status == fixrad::Status::converged && sum > 0.0f;
}

}  // namespace

int main() {
  const bool core_is_right = run_core();
  const bool stack_fits = fixrad::report::write_stack();
  const bool peer_is_right = run_peer();
  // The high-water mark of both.
  const uint32_t stack_used = fixrad::board::stack_used();
  fixrad::text::write_line("stack_used_with_peer", stack_used);
  const bool both_fit = stack_used < fixrad::board::stack_size();
  return core_is_right && stack_fits && peer_is_right && both_fit ? 0 : 1;
}

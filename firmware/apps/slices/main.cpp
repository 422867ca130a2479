// SPDX-License-Identifier: MIT
// Solves the scene FIXRAD_SCENE three times: in calls of one unit each, in calls of eight, and shot by shot,
// each call in a region of its own, that of one unit by what it does, so that the emulator's counters tell
// the largest. All three must give the
// same bits, those that the host has computed; with FIXRAD_PROBES the scene does not say which eyes are
// clear, so the core has to find out, and only equality is asked for.

#include <stdint.h>

#include FIXRAD_SCENE_HEADER
#include "firmware/apps/report.h"
#include "firmware/apps/text.h"
#include "firmware/boards/board.h"
#include "firmware/regions.h"

FIXRAD_REGION(search);
FIXRAD_REGION(sample);
FIXRAD_REGION(book);
FIXRAD_REGION(book_face);
FIXRAD_REGION(call_8);
FIXRAD_REGION(step);
FIXRAD_REGION(between);

namespace baked = FIXRAD_SCENE;

namespace {

baked::Solver solver;

struct Run {
  uint64_t digest;
  uint32_t calls, eyes, withdrawn;
  fixrad::Status status;
};

fixrad::Scene scene() {
  fixrad::Scene scene = baked::scene();
#ifdef FIXRAD_PROBES
  scene.sights = nullptr;
#endif
  return scene;
}

// `enter` names the region of a call of `step`.
template <class Enter, class Step>
Run run(const Enter& enter, const Step& step) {
  Run run = {0, 0, 0, 0, solver.load(scene(), baked::settings())};
  while (run.status == fixrad::Status::ok || run.status == fixrad::Status::in_progress) {
    enter();
    run.status = step();
    fixrad_region_between();
    ++run.calls;
  }
  run.digest = fixrad::digest(solver.state(), baked::vertex_map());
  run.eyes = solver.state().eyes;
  run.withdrawn = solver.state().withdrawn;
  return run;
}

// What a call of one unit is going to do.
void enter_unit() {
  const fixrad::State& state = solver.state();
  if (state.sampling.stage == fixrad::SamplingStage::none) {
    fixrad_region_search();
  } else if (state.sampling.stage < fixrad::SamplingStage::complete) {
    fixrad_region_sample();
  } else if (state.sweep.kind != fixrad::SourceKind::face) {
    fixrad_region_book();
  } else {
    fixrad_region_book_face();
  }
}

bool is_equal(const Run& a, const Run& b) {
  return a.digest == b.digest && a.eyes == b.eyes && a.withdrawn == b.withdrawn && a.status == b.status;
}

bool is_expected(const Run& run) {
#ifdef FIXRAD_PROBES
  return run.status == fixrad::Status::converged;
#else
  return run.status == fixrad::Status::converged && run.digest == baked::expected::kDigest;
#endif
}

}  // namespace

int main() {
  fixrad_region_between();
  const Run ones = run(enter_unit, [] { return solver.step(1); });
  const Run eights = run(fixrad_region_call_8, [] { return solver.step(8); });
  const Run whole = run(fixrad_region_step, [] { return solver.step(); });
  fixrad::text::write_line("calls_1", ones.calls);
  fixrad::text::write_line("calls_8", eights.calls);
  fixrad::text::write_line("steps", whole.calls);
  fixrad::text::write_line("eyes", whole.eyes);
  fixrad::text::write_line("withdrawn", whole.withdrawn);
  const bool all_equal = is_equal(ones, whole) && is_equal(eights, whole);
  fixrad::text::write_line("slices", all_equal ? "equal" : "differ");
  return all_equal && is_expected(whole) && fixrad::report::write_stack() ? 0 : 1;
}

// SPDX-License-Identifier: MIT
#include "firmware/apps/report.h"

#include "firmware/apps/text.h"
#include "firmware/boards/board.h"

namespace fixrad {
namespace report {
namespace {

void write_ledger(const State& state) {
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    const Ledger ledger = fixrad::ledger(state, c);
    const int64_t lines[5] = {ledger.emitted, ledger.absorbed, ledger.unshot, ledger.escaped, ledger.back};
    text::write("ledger ");
    text::write(uint32_t{c});
    for (const int64_t line : lines) {
      text::write(" ");
      text::write(line);
    }
    text::write("\nimbalance ");
    text::write(uint32_t{c});
    text::write(" ");
    text::write(ledger.imbalance());
    text::write("\n");
  }
}

void write_found_and_wanted(const Difference& difference) {
  text::write(": found ");
  text::write(difference.found);
  text::write(", wanted ");
  text::write(difference.wanted);
  text::write("\n");
}

}  // namespace

void write_solution(const State& state, Status status, uint64_t digest, uint32_t solver_bytes) {
  text::write_line("status", status == Status::converged ? "converged" : "failed");
  text::write_line("status_code", static_cast<uint32_t>(status));
  text::write_line("elements", uint32_t{state.scene.element_count});
  text::write_line("patches", uint32_t{state.scene.patch_count});
  text::write_line("shots", state.shots);
  text::write_line("eyes", state.eyes);
  text::write("digest ");
  text::write_hex(digest);
  text::write("\n");
  write_ledger(state);
  text::write_line("solver_bytes", solver_bytes);
}

bool write_stack() {
  const uint32_t used = board::stack_used(), size = board::stack_size();
  text::write_line("stack_used", used);
  text::write_line("stack_size", size);
  return used < size;
}

void write_difference(const Difference& difference) {
  static constexpr const char* kLines[5] = {"emitted", "absorbed", "unshot", "escaped", "back"};
  switch (difference.what) {
    case Disagreement::none:
      text::write("result equal\n");
      return;
    case Disagreement::received:
      text::write("result differs in the flux received by element ");
      text::write(uint32_t{difference.element});
      text::write(" channel ");
      text::write(uint32_t{difference.channel});
      break;
    case Disagreement::vertices:
      text::write("result differs in the vertex radiosities: every element agrees, the digest does not\n");
      return;
    case Disagreement::shots:
      text::write("result differs in the number of shots");
      break;
    case Disagreement::eyes:
      text::write("result differs in the number of eye points");
      break;
    case Disagreement::ledger:
      text::write("result differs in the ledger of channel ");
      text::write(uint32_t{difference.channel});
      text::write(", ");
      text::write(kLines[difference.line]);
      break;
  }
  write_found_and_wanted(difference);
}

}  // namespace report
}  // namespace fixrad

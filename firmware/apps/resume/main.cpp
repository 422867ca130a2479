// SPDX-License-Identifier: MIT
// Solves the scene FIXRAD_SCENE with a power cut amid it: after FIXRAD_SAVED_SHOTS shots the state is saved,
// printed as lines "saved OFFSET BYTES", and the solver's memory filled with rubbish. A new solver goes on
// from what was saved, and the end is compared with what the host has computed without a cut. Exit code 0 if
// every bit agrees and the stack kept to its place.

#include <stdint.h>

#include FIXRAD_SCENE_HEADER
#include "firmware/apps/report.h"
#include "firmware/apps/resume/storage.h"
#include "firmware/apps/text.h"
#include "firmware/regions.h"

FIXRAD_REGION(solve);
FIXRAD_REGION(identify);
FIXRAD_REGION(save);
FIXRAD_REGION(resume);
FIXRAD_REGION(end);

namespace baked = FIXRAD_SCENE;

namespace {

baked::Solver solver;

bool write(void* context, const uint8_t* bytes, uint8_t count) {
  uint16_t& end = *static_cast<uint16_t*>(context);
  bool is_written = true;
  for (uint8_t i = 0; i < count; ++i) {
    is_written = is_written && fixrad::storage::write(end++, bytes[i]);
  }
  return is_written;
}

bool read(void*, uint32_t offset, uint8_t* bytes, uint8_t count) {
  bool is_read = offset <= 0xff00u;
  for (uint8_t i = 0; is_read && i < count; ++i) {
    is_read = fixrad::storage::read(static_cast<uint16_t>(offset + i), bytes[i]);
  }
  return is_read;
}

void print(uint16_t count) {
  for (uint16_t at = 0; at < count; at = static_cast<uint16_t>(at + 8)) {
    uint64_t bytes = 0;  // the first one foremost; beyond the end zeros
    for (uint8_t i = 0; i < 8; ++i) {
      uint8_t byte = 0;
      if (at + i < count) {
        fixrad::storage::read(static_cast<uint16_t>(at + i), byte);
      }
      bytes = bytes << 8 | byte;
    }
    fixrad::text::write("saved ");
    fixrad::text::write(uint32_t{at});
    fixrad::text::write(" ");
    fixrad::text::write_hex(bytes);
    fixrad::text::write("\n");
  }
}

fixrad::Identity load() {
  fixrad_region_solve();
  const fixrad::Status status = solver.load(baked::scene(), baked::settings());
  fixrad_region_identify();
  const fixrad::Identity identity =
      status == fixrad::Status::ok ? solver.identify() : fixrad::Identity{0, 0, 0};
  fixrad_region_solve();
  return identity;
}

fixrad::SaveStatus save_half() {
  const fixrad::Identity identity = load();
  while (solver.state().shots < FIXRAD_SAVED_SHOTS && solver.step() == fixrad::Status::ok) {
  }
  uint16_t count = 0;
  fixrad_region_save();
  const fixrad::SaveStatus status = solver.save(identity, {&count, write});
  fixrad_region_end();
  fixrad::text::write_line("saved_bytes", uint32_t{count});
  print(count);
  return status;
}

void lose_power() {
  volatile uint8_t* bytes = reinterpret_cast<volatile uint8_t*>(&solver);
  for (uint16_t i = 0; i < sizeof solver; ++i) {
    bytes[i] = 0xa5;
  }
}

fixrad::SaveStatus resume() {
  const fixrad::Identity identity = load();
  fixrad_region_resume();
  const fixrad::SaveStatus status = solver.resume(identity, {nullptr, read});
  fixrad_region_end();
  return status;
}

fixrad::Difference compare(uint64_t digest) {
  namespace expected = baked::expected;
  return fixrad::compare(
      solver.state(), digest,
      {expected::kDigest, expected::kShots, expected::kEyes, expected::kLedger, expected::kReceived});
}

}  // namespace

int main() {
  const fixrad::SaveStatus saved = save_half();
  lose_power();
  const fixrad::SaveStatus resumed = resume();
  fixrad::text::write_line("save_status", static_cast<uint32_t>(saved));
  fixrad::text::write_line("resume_status", static_cast<uint32_t>(resumed));
  if (saved != fixrad::SaveStatus::ok || resumed != fixrad::SaveStatus::ok) {
    return 1;
  }
  fixrad::Status status = fixrad::Status::ok;
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  const uint64_t value = fixrad::digest(solver.state(), baked::vertex_map());
  fixrad::report::write_solution(solver.state(), status, value, sizeof solver);
  const bool stack_fits = fixrad::report::write_stack();
  const fixrad::Difference difference = compare(value);
  fixrad::report::write_difference(difference);
  const bool is_equal = status == fixrad::Status::converged && difference.what == fixrad::Disagreement::none;
  return is_equal && stack_fits ? 0 : 1;
}

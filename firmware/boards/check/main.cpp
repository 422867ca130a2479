// SPDX-License-Identifier: MIT
// What every board must do: console, cleared and filled RAM, exit codes, the stack's high-water mark.

#include <stdint.h>

#include "firmware/boards/board.h"
#include "firmware/regions.h"

FIXRAD_REGION(checks);

namespace board = fixrad::board;

namespace {

volatile uint32_t cleared[4];
volatile uint32_t filled[2] = {0x12345678, 0x9abcdef0};

// Uses kDeep bytes of stack and gives back something made of them, so that no compiler leaves them out.
constexpr uint16_t kDeep = 400;
__attribute__((noinline)) uint16_t use_stack(uint8_t seed) {
  volatile uint8_t bytes[kDeep];
  for (uint16_t i = 0; i < kDeep; ++i) {
    bytes[i] = seed;
  }
  uint16_t sum = 0;
  for (uint16_t i = 0; i < kDeep; ++i) {
    sum = static_cast<uint16_t>(sum + bytes[i]);
  }
  return sum;
}

int fail(const char* what) {
  board::write(what);
  return 1;
}

int check() {
  for (const volatile uint32_t& word : cleared) {
    if (word != 0) {
      return fail("static data that starts as 0 was not cleared\n");
    }
  }
  if (filled[0] != 0x12345678 || filled[1] != 0x9abcdef0) {
    return fail("initialised data was not filled in\n");
  }
  const uint32_t before = board::stack_used();
  if (before == 0 || before >= kDeep || before >= board::stack_size()) {
    return fail("the stack is not painted: its high-water mark is wrong at the start\n");
  }
  if (use_stack(3) != 3 * kDeep) {
    return fail("the stack does not hold what is written to it\n");
  }
  const uint32_t after = board::stack_used();
  if (after < kDeep || after > kDeep + before + 64) {
    return fail("the stack's high-water mark does not follow its use\n");
  }
  return 0;
}

}  // namespace

int main() {
  fixrad_region_checks();
  const int failed = check();
  if (failed != 0) {
    return failed;
  }
  board::write("board ok\n");
  return 42;
}

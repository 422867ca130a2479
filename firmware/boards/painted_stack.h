// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/board.h"

// The painted stack of all boards whose linker script defines its two ends. Paint is a byte pattern that code
// rarely leaves behind: a byte that differs from it has been used.

extern "C" {
extern uint8_t fixrad_stack_limit[];  // lowest address
extern uint8_t fixrad_stack_top[];    // one past the highest
}

namespace fixrad {
namespace board {

constexpr uint8_t kPaint = 0xa5;

/// Paints the stack below the caller's frame; first thing in start-up. No calls: its own frame must stay
/// small.
inline __attribute__((always_inline)) void paint_stack() {
  // A margin for what this function keeps on the stack below its frame address.
  constexpr uintptr_t margin = 32;
  volatile uint8_t* end =
      reinterpret_cast<uint8_t*>(reinterpret_cast<uintptr_t>(__builtin_frame_address(0)) - margin);
  for (volatile uint8_t* p = fixrad_stack_limit; p < end; p = p + 1) {
    *p = kPaint;
  }
}

uint32_t stack_used() {
  const uint8_t* p = fixrad_stack_limit;
  while (p < fixrad_stack_top && *p == kPaint) {
    ++p;
  }
  return static_cast<uint32_t>(fixrad_stack_top - p);
}

uint32_t stack_size() {
  return static_cast<uint32_t>(fixrad_stack_top - fixrad_stack_limit);
}

}  // namespace board
}  // namespace fixrad

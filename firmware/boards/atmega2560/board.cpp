// SPDX-License-Identifier: MIT
// ATmega2560 in simavr. The C library's start-up code sets up RAM and calls main(); the simulator watches two
// registers that have no function on the chip: what is written to GPIOR0 appears on the console, GPIOR2 takes
// the exit code, and is believed if GPIOR1 holds the key.

#include "firmware/boards/board.h"

#include <avr/io.h>
#include <stdint.h>

#include "firmware/boards/painted_stack.h"

extern "C" {
void paint_all();
[[noreturn]] void exit(int code);
[[noreturn]] void __vector_default();
}

// Start-up code runs the sections .init0 .. .init9 one after the other, as one straight piece of code: in
// .init3 the stack pointer is set and RAM has not been filled yet. Nothing has been pushed, so all of the
// stack is painted.
extern "C" __attribute__((naked, used, section(".init3"))) void paint_all() {
  asm volatile(
      "ldi r30, lo8(fixrad_stack_limit)\n"
      "ldi r31, hi8(fixrad_stack_limit)\n"
      "ldi r24, %0\n"
      "ldi r25, hi8(fixrad_stack_top)\n"
      "1: st Z+, r24\n"
      "cpi r30, lo8(fixrad_stack_top)\n"
      "cpc r31, r25\n"
      "brne 1b\n"
      :
      : "i"(fixrad::board::kPaint));
}

namespace fixrad {
namespace board {

void write(const char* text) {
  for (; *text != '\0'; ++text) {
    GPIOR0 = static_cast<uint8_t>(*text);
  }
}

void exit(int code) {
  constexpr uint8_t key = 0x5a;
  GPIOR1 = key;
  for (;;) {
    GPIOR2 = static_cast<uint8_t>(code);
  }
}

}  // namespace board
}  // namespace fixrad

// Called with what main() returns.
void exit(int code) {
  fixrad::board::exit(code);
}

// Every interrupt that nobody handles; the core itself knows no faults.
void __vector_default() {
  fixrad::board::write("fault: an interrupt that nobody handles\n");
  fixrad::board::exit(fixrad::board::kFaultExit);
}

// SPDX-License-Identifier: MIT
// Runs into a fault on purpose: an instruction that the core does not have, on AVR, where no instruction
// faults, an interrupt that nobody handles.

#include "firmware/boards/board.h"

#ifdef __AVR__
extern "C" [[noreturn]] void __vector_1();
#endif

int main() {
#ifdef __AVR__
  __vector_1();
#elif defined(__XTENSA__)
  asm volatile("ill");
#elif defined(__riscv)
  asm volatile("unimp");
#else
  asm volatile("udf #0");
#endif
  fixrad::board::write("the fault was not noticed\n");
  return 0;
}

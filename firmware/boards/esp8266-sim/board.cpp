// SPDX-License-Identifier: MIT
// ESP8266 core in QEMU's `sim`: console and exit through the simulator's calls, an exception is a fault.

#include "firmware/boards/board.h"

#include <stdint.h>

#include "firmware/boards/painted_stack.h"
#include "firmware/boards/static_constructors.h"

extern "C" {
extern uint32_t fixrad_bss_start[], fixrad_bss_end[];
int main();
[[noreturn]] void start();
[[noreturn]] void fault();
[[noreturn]] void simulator_exit(int code);
void simulator_write(const char* text, uint32_t bytes);
}

namespace fixrad {
namespace board {

void write(const char* text) {
  uint32_t bytes = 0;
  while (text[bytes] != '\0') {
    ++bytes;
  }
  simulator_write(text, bytes);
}

void exit(int code) {
  simulator_exit(code);
}

}  // namespace board
}  // namespace fixrad

void start() {
  fixrad::board::paint_stack();
  // QEMU loads initialised data straight to RAM.
  for (uint32_t* to = fixrad_bss_start; to < fixrad_bss_end; ++to) {
    *to = 0;
  }
  fixrad::board::run_static_constructors();
  fixrad::board::exit(main());
}

void fault() {
  fixrad::board::write("fault: the core stopped at an instruction or address that it refuses\n");
  fixrad::board::exit(fixrad::board::kFaultExit);
}

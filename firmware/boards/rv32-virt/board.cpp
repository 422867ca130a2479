// SPDX-License-Identifier: MIT
// RV32 on QEMU's `virt`: console on the 16550 UART, exit through the test finisher, a trap is a fault.

#include "firmware/boards/board.h"

#include <stdint.h>

#include "firmware/boards/painted_stack.h"
#include "firmware/boards/static_constructors.h"

extern "C" {
extern uint32_t fixrad_bss_start[], fixrad_bss_end[];
int main();
[[noreturn]] void start();
[[noreturn]] void fault();
}

namespace {

volatile uint8_t& uart_transmit() {
  return *reinterpret_cast<volatile uint8_t*>(0x10000000);
}
volatile uint8_t& uart_line_status() {
  return *reinterpret_cast<volatile uint8_t*>(0x10000005);
}
constexpr uint8_t kTransmitterEmpty = 1u << 5;

volatile uint32_t& test_finisher() {
  return *reinterpret_cast<volatile uint32_t*>(0x00100000);
}
constexpr uint32_t kPass = 0x5555;
constexpr uint32_t kFail = 0x3333;  // the exit code in the upper half

}  // namespace

namespace fixrad {
namespace board {

void write(const char* text) {
  for (; *text != '\0'; ++text) {
    while ((uart_line_status() & kTransmitterEmpty) == 0) {
    }
    uart_transmit() = static_cast<uint8_t>(*text);
  }
}

void exit(int code) {
  test_finisher() = code == 0 ? kPass : (static_cast<uint32_t>(code) << 16) | kFail;
  for (;;) {
  }
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

// SPDX-License-Identifier: MIT
// Start-up, semihosting console and faults of every Cortex-M board. The linker script names the memories.

#include <stdint.h>

#include "firmware/boards/board.h"
#include "firmware/boards/painted_stack.h"
#include "firmware/boards/static_constructors.h"

extern "C" {
extern uint32_t fixrad_data_start[], fixrad_data_end[], fixrad_data_load[];
extern uint32_t fixrad_bss_start[], fixrad_bss_end[];
int main();
[[noreturn]] void reset_handler();
[[noreturn]] void fault_handler();
}

namespace {

constexpr uint32_t kSysWrite0 = 0x04;
// The plain SYS_EXIT carries no exit code on 32-bit cores.
constexpr uint32_t kSysExitExtended = 0x20;
constexpr uint32_t kApplicationExit = 0x20026;

void semihosting(uint32_t operation, const void* argument) {
  register uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory", "cc");
}

inline void enable_fpu() {
#ifdef __ARM_FP
  constexpr uint32_t coprocessor_access_control = 0xe000ed88;
  *reinterpret_cast<volatile uint32_t*>(coprocessor_access_control) |= 0xfu << 20;
  asm volatile("dsb\n isb" ::: "memory");
#endif
}

}  // namespace

namespace fixrad {
namespace board {

void write(const char* text) {
  semihosting(kSysWrite0, text);
}

void exit(int code) {
  const uint32_t block[2] = {kApplicationExit, static_cast<uint32_t>(code)};
  semihosting(kSysExitExtended, block);
  for (;;) {
  }
}

}  // namespace board
}  // namespace fixrad

void reset_handler() {
  fixrad::board::paint_stack();
  enable_fpu();
  const uint32_t* from = fixrad_data_load;
  for (uint32_t* to = fixrad_data_start; to < fixrad_data_end; ++to) {
    *to = *from++;
  }
  for (uint32_t* to = fixrad_bss_start; to < fixrad_bss_end; ++to) {
    *to = 0;
  }
  fixrad::board::run_static_constructors();
  fixrad::board::exit(main());
}

void fault_handler() {
  fixrad::board::write("fault: the core stopped at an instruction or address that it refuses\n");
  fixrad::board::exit(fixrad::board::kFaultExit);
}

namespace {

using Handler = void (*)();

// The stack pointer, reset, and fourteen exceptions of the core; none of them is expected.
struct Vectors {
  uint8_t* stack_top;
  Handler reset;
  Handler exceptions[14];
};

__attribute__((section(".vectors"), used))
const Vectors vectors = {fixrad_stack_top,
                         reset_handler,
                         {fault_handler, fault_handler, fault_handler, fault_handler, fault_handler,
                          fault_handler, fault_handler, fault_handler, fault_handler, fault_handler,
                          fault_handler, fault_handler, fault_handler, fault_handler}};

}  // namespace

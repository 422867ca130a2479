// SPDX-License-Identifier: MIT
// What newlib's start-up code leaves to the program: the vectors, the floating-point unit, an end after a
// fault.
#include <stdint.h>

extern "C" {
extern uint32_t __stack[];
void _start();
int mkdir(const char* path, unsigned mode);
}

namespace {

void start() {
#ifdef __ARM_FP
  constexpr uint32_t coprocessor_access_control = 0xe000ed88;
  *reinterpret_cast<volatile uint32_t*>(coprocessor_access_control) |= 0xfu << 20;
  asm volatile("dsb\n isb" ::: "memory");
#endif
  _start();
}

void fault() {
  constexpr uint32_t sys_exit_extended = 0x20;
  static constexpr uint32_t application_exit_101[2] = {0x20026, 101};
  register uint32_t r0 asm("r0") = sys_exit_extended;
  register const uint32_t* r1 asm("r1") = application_exit_101;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  for (;;) {
  }
}

using Handler = void (*)();

struct Vectors {
  uint32_t* stack;
  Handler handlers[15];
};

__attribute__((section(".vectors"), used))
const Vectors vectors = {__stack,
                         {start, fault, fault, fault, fault, fault, nullptr, nullptr, nullptr, nullptr, fault,
                          fault, nullptr, fault, fault}};

}  // namespace

// GoogleTest can make a folder for its reports; there are none here.
int mkdir(const char*, unsigned) {
  return -1;
}

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// What an application may ask of a board; each folder beside this file implements it for one board or
/// emulator. Start-up code clears and fills RAM, paints the stack, calls main() and takes its value as the
/// exit code. A fault that the core detects ends the program with kFaultExit and a line on the console.
namespace fixrad {
namespace board {

/// Exit code of a program that has run into a fault.
constexpr int kFaultExit = 101;

/// Writes a string, zero-terminated, to the console. Blocking.
void write(const char* text);

/// Ends the program; `code` (0 .. 255) is what the emulator returns, 0 for success.
[[noreturn]] void exit(int code);

/// Most bytes of stack ever used since start-up: the painted words that have been overwritten. Cost: linear
/// in stack_size().
uint32_t stack_used();

/// Bytes reserved for the stack. stack_used() reaching it means that the stack may have grown into data.
uint32_t stack_size();

}  // namespace board
}  // namespace fixrad

// SPDX-License-Identifier: MIT
// 32-bit shifts by a variable count, which clang calls and libgcc for AVR does not have. Whole bytes first: a
// loop over single bits alone would take up to 31 turns.

#include <stdint.h>

extern "C" {
uint32_t __ashlsi3(uint32_t value, uint8_t count);
uint32_t __lshrsi3(uint32_t value, uint8_t count);
int32_t __ashrsi3(int32_t value, uint8_t count);
}

uint32_t __ashlsi3(uint32_t value, uint8_t count) {
  for (; count >= 8; count = static_cast<uint8_t>(count - 8)) {
    value <<= 8;
  }
  for (; count > 0; --count) {
    value <<= 1;
  }
  return value;
}

uint32_t __lshrsi3(uint32_t value, uint8_t count) {
  for (; count >= 8; count = static_cast<uint8_t>(count - 8)) {
    value >>= 8;
  }
  for (; count > 0; --count) {
    value >>= 1;
  }
  return value;
}

int32_t __ashrsi3(int32_t value, uint8_t count) {
  for (; count >= 8; count = static_cast<uint8_t>(count - 8)) {
    value >>= 8;
  }
  for (; count > 0; --count) {
    value >>= 1;
  }
  return value;
}

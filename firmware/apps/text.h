// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

// Numbers on the console, without a C library and without 64-bit division, which not every target has.

namespace fixrad {
namespace text {

/// Writes a string.
void write(const char* text);

/// Writes `value` in decimal.
void write(uint64_t value);
void write(uint32_t value);

/// Writes `value` in decimal, with a sign if it is negative; every value, also the smallest.
void write(int64_t value);

/// Writes `value` as 16 hexadecimal digits.
void write_hex(uint64_t value);

/// Writes a line "key value".
template <class T>
inline void write_line(const char* key, T value) {
  write(key);
  write(" ");
  write(value);
  write("\n");
}

}  // namespace text
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "firmware/apps/text.h"

#include "firmware/boards/board.h"

namespace fixrad {
namespace text {
namespace {

// Divides `value` by ten in place and returns the remainder. Cost: four 32-bit divisions.
uint8_t take_digit(uint64_t& value) {
  uint64_t quotient = 0;
  uint32_t remainder = 0;
  for (uint8_t i = 0; i < 4; ++i) {
    const uint32_t part = remainder << 16 | static_cast<uint32_t>(value >> 48);
    quotient = quotient << 16 | (part / 10u);
    remainder = part % 10u;
    value <<= 16;
  }
  value = quotient;
  return static_cast<uint8_t>(remainder);
}

}  // namespace

void write(const char* text) {
  board::write(text);
}

void write(uint64_t value) {
  char digits[21];
  char* at = digits + sizeof digits;
  *--at = '\0';
  do {
    *--at = static_cast<char>('0' + take_digit(value));
  } while (value != 0);
  write(at);
}

void write(uint32_t value) {
  write(uint64_t{value});
}

void write(int64_t value) {
  if (value < 0) {
    write("-");
  }
  const uint64_t bits = static_cast<uint64_t>(value);
  write(value < 0 ? uint64_t{0} - bits : bits);
}

void write_hex(uint64_t value) {
  char digits[17];
  for (uint8_t i = 16; i > 0; --i) {
    const uint8_t digit = static_cast<uint8_t>(value & 15u);
    digits[i - 1] = static_cast<char>(digit < 10 ? '0' + digit : 'a' + (digit - 10));
    value >>= 4;
  }
  digits[16] = '\0';
  write(digits);
}

}  // namespace text
}  // namespace fixrad

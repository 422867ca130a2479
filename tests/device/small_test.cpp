// SPDX-License-Identifier: MIT
#include "tests/device/small_test.h"

#include "firmware/boards/board.h"

namespace fixrad {
namespace small_test {
namespace {

// There before the first constructor runs, in whatever file it stands.
Case* first = nullptr;
bool has_failed = false;

// board::write() takes text in RAM.
void write_flash(const FIXRAD_FLASH char* text) {
  char part[17];
  unsigned char length = 0;
  do {
    length = 0;
    for (char c; length < 16 && (c = flash_read(text, 0)) != '\0'; ++text) {
      part[length++] = c;
    }
    part[length] = '\0';
    board::write(part);
  } while (length == 16);
}

void write_digits(uint64_t value, unsigned char base) {
  char text[21];
  char* digit = text + sizeof text - 1;
  *digit = '\0';
  do {
    *--digit = "0123456789abcdef"[static_cast<unsigned char>(value % base)];
    value /= base;
  } while (value != 0);
  board::write(digit);
}

void write_value(const Value& value) {
  board::write(value.is_negative ? "-0x" : "0x");
  write_digits(value.magnitude, 16);
}

void write_place(const FIXRAD_FLASH char* file, uint16_t line, const FIXRAD_FLASH char* expected) {
  has_failed = true;
  write_flash(file);
  board::write(":");
  write_digits(line, 10);
  board::write(": expected ");
  write_flash(expected);
}

}  // namespace

Case::Case(const FIXRAD_FLASH char* name, void (*run)()) : name_(name), run_(run), next_(first) {
  first = this;
}

void fail(const FIXRAD_FLASH char* file, uint16_t line, const FIXRAD_FLASH char* expected) {
  write_place(file, line, expected);
  board::write("\n");
}

void fail(const FIXRAD_FLASH char* file, uint16_t line, const FIXRAD_FLASH char* expected, const Value& a,
          const Value& b) {
  write_place(file, line, expected);
  board::write(", got ");
  write_value(a);
  board::write(" and ");
  write_value(b);
  board::write("\n");
}

int run_all() {
  uint16_t passed = 0;
  uint16_t failed = 0;
  for (const Case* test = first; test != nullptr; test = test->next_) {
    has_failed = false;
    test->run_();
    ++(has_failed ? failed : passed);
    board::write(has_failed ? "FAILED " : "ok     ");
    write_flash(test->name_);
    board::write("\n");
  }
  write_digits(passed, 10);
  board::write(" passed, ");
  write_digits(failed, 10);
  board::write(" failed\n");
  return passed > 0 && failed == 0 ? 0 : 1;
}

}  // namespace small_test
}  // namespace fixrad

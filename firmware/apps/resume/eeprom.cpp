// SPDX-License-Identifier: MIT
#include <avr/io.h>

#include "firmware/apps/resume/storage.h"

namespace fixrad {
namespace storage {
namespace {

void wait() {
  while ((EECR & (1u << EEPE)) != 0) {
  }
}

}  // namespace

// The second bit must follow the first within four cycles: two instructions that set a bit.
bool write(uint16_t offset, uint8_t byte) {
  uint8_t there = 0;
  if (!read(offset, there)) {
    return false;
  }
  if (there == byte) {
    return true;  // a cell wears with every write
  }
  EEDR = byte;
  __asm__ __volatile__("sbi %0, %1\n\tsbi %0, %2" : : "I"(_SFR_IO_ADDR(EECR)), "I"(EEMPE), "I"(EEPE));
  return true;
}

bool read(uint16_t offset, uint8_t& byte) {
  if (offset > E2END) {
    return false;
  }
  wait();
  EEAR = offset;
  EECR = static_cast<uint8_t>(EECR | 1u << EERE);
  byte = EEDR;
  return true;
}

}  // namespace storage
}  // namespace fixrad

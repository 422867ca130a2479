// SPDX-License-Identifier: MIT
// Indexes a table in flash as if it were in RAM.
#include "lib/fixed/flash.h"

namespace fixrad {

const FIXRAD_IN_FLASH uint16_t kTable[] = {1, 2, 3};

uint16_t at(uint8_t index) {
  return kTable[index];
}

}  // namespace fixrad

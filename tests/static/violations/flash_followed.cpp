// SPDX-License-Identifier: MIT
// Follows a pointer into flash instead of calling flash_read(): avr-gcc would read RAM.
#include "lib/fixed/flash.h"

namespace fixrad {

uint16_t first(const FIXRAD_FLASH uint16_t* table) {
  return *table;
}

}  // namespace fixrad

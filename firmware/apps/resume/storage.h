// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

// Memory that outlives a power cut, as `resume` needs it: on an ATmega2560 its 4 KB of EEPROM, on the other
// boards, whose emulators have none, a part of RAM that the program does not clear.

namespace fixrad {
namespace storage {

/// Puts `byte` at `offset`; false if there is no such place. Cost on an ATmega2560: 3.3 ms where the byte
/// changes.
bool write(uint16_t offset, uint8_t byte);

/// The byte at `offset` into `byte`; false if there is no such place.
bool read(uint16_t offset, uint8_t& byte);

}  // namespace storage
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace fixrad {

/// CRC-32 as of IEEE 802.3: polynomial 0x04c11db7 with the lowest bit first (0xedb88320), begun and ended
/// with all ones. Tells every error that is confined to 32 bits in a row, so every single flipped bit, from
/// no error, and of all others all but one in 2^32. Without a table. Cost: eight shifts a byte.
class Checksum {
 public:
  void add(uint8_t byte) {
    rest_ ^= byte;
    for (uint8_t bit = 0; bit < 8; ++bit) {
      rest_ = (rest_ & 1u) != 0 ? (rest_ >> 1) ^ 0xedb88320u : rest_ >> 1;
    }
  }

  uint32_t value() const { return ~rest_; }

 private:
  uint32_t rest_ = 0xffffffffu;
};

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#include "firmware/apps/resume/storage.h"

namespace fixrad {
namespace storage {
namespace {

uint8_t retained[FIXRAD_RETAINED_BYTES];

}  // namespace

bool write(uint16_t offset, uint8_t byte) {
  if (offset >= sizeof retained) {
    return false;
  }
  retained[offset] = byte;
  return true;
}

bool read(uint16_t offset, uint8_t& byte) {
  if (offset >= sizeof retained) {
    return false;
  }
  byte = retained[offset];
  return true;
}

}  // namespace storage
}  // namespace fixrad

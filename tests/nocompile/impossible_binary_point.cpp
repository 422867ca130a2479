// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

using Coarse = fixrad::Q<int32_t, 8>;
using Fine = fixrad::Q<int32_t, 16>;

#ifndef FIXRAD_CONTROL
const fixrad::Q<uint16_t, 17> impossible = fixrad::Q<uint16_t, 17>::from_raw(0);
#endif

uint32_t half() {
  return fixrad::Reflectance::from_raw(0x80000000u).raw;
}

// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

using Coarse = fixrad::Q<int32_t, 8>;
using Fine = fixrad::Q<int32_t, 16>;

Fine convert(int bits) {
#ifndef FIXRAD_CONTROL
  const Fine implicit = bits;
  static_cast<void>(implicit);
#endif
  return Fine::from_raw(bits);
}

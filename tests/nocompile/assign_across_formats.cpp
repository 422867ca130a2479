// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

using Coarse = fixrad::Q<int32_t, 8>;
using Fine = fixrad::Q<int32_t, 16>;

Fine assign(Fine a, Coarse b) {
#ifndef FIXRAD_CONTROL
  a = b;
#endif
  static_cast<void>(b);
  return a;
}

// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

using Coarse = fixrad::Q<int32_t, 8>;
using Fine = fixrad::Q<int32_t, 16>;

Fine add(Fine a) {
#ifndef FIXRAD_CONTROL
  a = a + 1;
#endif
  return a;
}

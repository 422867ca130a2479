// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

using Coarse = fixrad::Q<int32_t, 8>;
using Fine = fixrad::Q<int32_t, 16>;

Fine scale(Fine a) {
#ifndef FIXRAD_CONTROL
  a = a * 0.5F;
#endif
  return a;
}

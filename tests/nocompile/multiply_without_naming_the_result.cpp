// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

using Coarse = fixrad::Q<int32_t, 8>;
using Fine = fixrad::Q<int32_t, 16>;

Fine square(Fine a) {
#ifndef FIXRAD_CONTROL
  a = a * a;
#endif
  return a;
}

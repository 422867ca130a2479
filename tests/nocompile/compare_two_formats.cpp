// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

using Coarse = fixrad::Q<int32_t, 8>;
using Fine = fixrad::Q<int32_t, 16>;

bool is_less(Fine a, Coarse b) {
#ifndef FIXRAD_CONTROL
  if (a < b) {
    return true;
  }
#endif
  static_cast<void>(a);
  static_cast<void>(b);
  return false;
}

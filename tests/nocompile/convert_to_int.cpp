// SPDX-License-Identifier: MIT
#include "lib/fixed/q.h"

using Coarse = fixrad::Q<int32_t, 8>;
using Fine = fixrad::Q<int32_t, 16>;

int convert(Fine a) {
#ifndef FIXRAD_CONTROL
  const int bits = a;
  static_cast<void>(bits);
#endif
  return a.raw;
}

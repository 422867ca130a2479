// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/checked.h"

namespace fixrad {

/// FNV-1a, 64 bits (Fowler, Noll, Vo): the hash of nothing.
constexpr uint64_t kFnvOfNothing = 14695981039346656037u;

/// The hash of what `hash` is of, followed by the four bytes of `word`, least significant first.
FIXRAD_MODULO inline uint64_t fnv1a(uint64_t hash, uint32_t word) {
  for (int i = 0; i < 4; ++i) {
    hash = (hash ^ ((word >> (8 * i)) & 0xffu)) * 1099511628211u;
  }
  return hash;
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

extern "C" {
using StaticConstructor = void (*)();
extern StaticConstructor fixrad_constructors_start[];
extern StaticConstructor fixrad_constructors_end[];
}

namespace fixrad {
namespace board {

/// Runs the constructors of static objects that a compiler could not turn into initial values; the linker
/// script gathers them. For start-up code, after RAM has its initial values.
inline void run_static_constructors() {
  for (StaticConstructor* constructor = fixrad_constructors_start; constructor < fixrad_constructors_end;
       ++constructor) {
    (*constructor)();
  }
}

}  // namespace board
}  // namespace fixrad

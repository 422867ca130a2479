// SPDX-License-Identifier: MIT
#pragma once

/// Names a stretch of the program for the emulators' counters. At namespace scope, once a program,
/// FIXRAD_REGION(solve) defines the function fixrad_region_solve(); calling it means "what runs from here on
/// counts as `solve`", until another such function is called. Cost on a chip: an empty call.
///
/// The comment inside keeps each function's body different, else a compiler may make them one, and one
/// address would stand for several regions.
#define FIXRAD_REGION(name)                                                \
  extern "C" void fixrad_region_##name();                                  \
  extern "C" __attribute__((noinline, used)) void fixrad_region_##name() { \
    asm volatile("/* " #name " */" ::: "memory");                          \
  }                                                                        \
  static_assert(true, "a semicolon may follow")

// SPDX-License-Identifier: MIT
#ifndef FIXRAD_EMULATORS_COUNTS_H
#define FIXRAD_EMULATORS_COUNTS_H

#include <stdint.h>

// What was executed at each address, apart for each region of the program; written as JSON:
//   {"unit": "instructions", "total": n, "stack_low": address or null,
//    "regions": {"start": {"count": n, "entries": n, "largest": n, "by_pc": {"0x80": n, ...}}, "load": ...}}
// `largest` is the most that was counted from one entry into the region to the next entry into any. Regions
// appear in the order in which they were first entered; `start` is what runs before the first.

/// Declares a region that begins whenever the instruction at `address` is executed. `name` is copied. Exits
/// with a message if there are more than 63.
void counts_declare_region(const char* name, uint64_t address);

/// The region that begins at `address`, or -1.
int counts_region_at(uint64_t address);

/// The counter of `address`; its place never changes. Add to it what the instruction there costs.
uint64_t* counts_at(uint64_t address);

/// What is counted from here on belongs to `region`. Cost: linear in the code that has run.
void counts_enter(int region);

/// Writes the file; `stack_low` is the lowest stack pointer seen, or UINT64_MAX if nobody watched. Returns 0,
/// or -1 if the file cannot be written.
int counts_write(const char* path, const char* unit, uint64_t stack_low);

#endif

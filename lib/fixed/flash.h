// SPDX-License-Identifier: MIT
#pragma once

// Constant data (the scene, the delta form-factor tables) may live in another address space than RAM: on AVR
// in program memory. Every pointer to such data is declared FIXRAD_FLASH and read by value through
// flash_read().

#ifndef FIXRAD_FLASH
#define FIXRAD_FLASH
#endif

namespace fixrad {

/// The record at `index` of a table in flash, by value. Cost: one copy of T.
template <class T>
inline T flash_read(const FIXRAD_FLASH T* table, unsigned index) {
  return table[index];
}

/// The same record in place, for code that needs few of its fields.
template <class T>
inline const FIXRAD_FLASH T& flash_at(const FIXRAD_FLASH T* table, unsigned index) {
  return table[index];
}

}  // namespace fixrad

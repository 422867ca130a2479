// SPDX-License-Identifier: MIT
#pragma once

// Constant data (the scene, the delta form-factor tables) may live in another address space than RAM: on AVR
// in program memory. Every pointer to such data is declared FIXRAD_FLASH and read by value through
// flash_read(), or field by field through flash_at().

#ifndef FIXRAD_FLASH
#ifdef __AVR__
#define FIXRAD_FLASH __attribute__((address_space(1)))
#else
#define FIXRAD_FLASH
#endif
#endif

namespace fixrad {

/// The record at `index` of a table in flash, in place: for code that needs few of its fields. Where flash is
/// another address space only fields of arithmetic type can be read from it.
template <class T>
inline const FIXRAD_FLASH T& flash_at(const FIXRAD_FLASH T* table, unsigned index) {
  return table[index];
}

/// The same record by value; T is a plain struct or an arithmetic type. Cost: one copy of T.
template <class T>
inline T flash_read(const FIXRAD_FLASH T* table, unsigned index) {
#ifdef __AVR__
  // Copy constructors take references to RAM: the record is fetched byte by byte. Volatile, since clang would
  // make a memcpy of the loop, which it cannot lower from this address space.
  T value;
  const auto* from = reinterpret_cast<const volatile FIXRAD_FLASH unsigned char*>(table + index);
  auto* to = reinterpret_cast<unsigned char*>(&value);
  for (unsigned char left = sizeof(T); left != 0; --left) {
    *to++ = *from++;
  }
  return value;
#else
  return table[index];
#endif
}

}  // namespace fixrad

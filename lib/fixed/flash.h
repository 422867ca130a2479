// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

// Constant data (the scene, the delta form-factor tables) may live in another address space than RAM: on AVR
// in program memory, of which instructions reach the first 64 KB. Every such table is defined
// FIXRAD_IN_FLASH, every pointer to one is declared FIXRAD_FLASH, and what it points at is read through
// flash_read() or flash_at() only. avr-gcc has no type for such pointers in C++ and would read RAM at their
// address. clang has one: it keeps them apart from other pointers and, by `noderef`, refuses to follow them
// anywhere else. It checks the core in a test and builds no firmware.
#if !defined(__AVR__)
#define FIXRAD_IN_FLASH
#define FIXRAD_FLASH
#elif defined(__clang__)
#define FIXRAD_IN_FLASH __attribute__((address_space(1), noderef))
#define FIXRAD_FLASH __attribute__((address_space(1), noderef))
#else
#define FIXRAD_IN_FLASH __attribute__((__progmem__))
#define FIXRAD_FLASH
#endif

namespace fixrad {

#if defined(__AVR__)

/// The byte of flash at `from`, which moves on. Cost: 3 cycles.
inline uint8_t flash_byte(const FIXRAD_FLASH uint8_t*& from) {
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wnoderef"
  return *from++;
#pragma clang diagnostic pop
#else
  uint8_t value;
  __asm__("lpm %0, %a1+" : "=r"(value), "+z"(from));
  return value;
#endif
}

/// The record at `index` of a table in flash, by value; T is a plain struct or an arithmetic type.
template <class T>
inline T flash_read(const FIXRAD_FLASH T* table, unsigned index) {
  T value;
  const FIXRAD_FLASH uint8_t* from = reinterpret_cast<const FIXRAD_FLASH uint8_t*>(table + index);
  uint8_t* to = reinterpret_cast<uint8_t*>(&value);
  for (uint8_t left = sizeof(T); left != 0; --left) {
    *to++ = flash_byte(from);
  }
  return value;
}

/// The same, for code that needs few fields of a record: in place where flash can be addressed.
template <class T>
inline T flash_at(const FIXRAD_FLASH T* table, unsigned index) {
  return flash_read(table, index);
}

#else

template <class T>
inline T flash_read(const FIXRAD_FLASH T* table, unsigned index) {
  return table[index];
}

template <class T>
inline const FIXRAD_FLASH T& flash_at(const FIXRAD_FLASH T* table, unsigned index) {
  return table[index];
}

#endif

}  // namespace fixrad

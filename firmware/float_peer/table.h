// SPDX-License-Identifier: MIT
#pragma once

#include "lib/fixed/flash.h"

// On AVR the peer is compiled by avr-gcc (CMakeLists.txt says why), which has no address spaces in C++: its
// tables carry an attribute instead, and are read by the instruction for it.
#if defined(__AVR__) && !defined(__clang__)
#define FIXRAD_PEER_TABLE __attribute__((progmem))
#else
#define FIXRAD_PEER_TABLE FIXRAD_FLASH
#endif

namespace fixrad {
namespace peer {

/// The record at `index` of a table in flash, by value: flash_read() for both compilers. T is a plain struct
/// or an arithmetic type.
template <class T>
inline T read(const FIXRAD_FLASH T* table, unsigned index) {
#if defined(__AVR__) && !defined(__clang__)
  T value;
  const T* from = table + index;
  auto* to = reinterpret_cast<unsigned char*>(&value);
  for (unsigned char left = sizeof(T); left != 0; --left) {
    asm("lpm %0, %a1+" : "=r"(*to), "+z"(from));
    ++to;
  }
  return value;
#else
  return flash_read(table, index);
#endif
}

}  // namespace peer
}  // namespace fixrad

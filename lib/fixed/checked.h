// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

// Where a number is cut to its format, the place has a name. docs/numbers.md argues that all places before
// kMeant never change a number; built with FIXRAD_CHECKED each counts how often it did, and the tests end
// with all those counts at zero. Built without, names cost nothing.

namespace fixrad {

enum class Place : uint8_t {
  direction,          ///< a vertex seen from the eye, 15 bits
  depth_of_plane,     ///< a face's depth block, 15 bits
  row_position,       ///< ends of spans, 13 bits
  element_of_cell,    ///< an element's number, 16 bits
  eye_of_part,        ///< of a split element, 16 bits
  offset_of_cut,      ///< of a split element, 12 bits and a sign
  emitted_flux,       ///< 31 bits
  piece_of_flux,      ///< 31 bits
  element_radiosity,  ///< 32 bits; saturates
  ambient_radiosity,
  gathered_radiosity,
  vertex_radiosity,
  irradiance,
  sum_of_pairs,    ///< UQ2.30; saturates
  clipped_light,   ///< UQ4.12 between two such
  clipped_normal,  ///< Q1.14 between two such
  kMeant,
  unshot_fraction =
      kMeant,        ///< UQ0.32 has no 1: before the first shot, or with loans, all is unshot and more
  depth_reciprocal,  ///< the one quotient of 2^16
  matrix_entry,      ///< UQ0.16 has no 1: an element that fills the whole hemisphere
  light_of_picture,  ///< 16 times white is white
  light_of_lamp,     ///< a highlight beside its lamp; likewise
  error_of_element,  ///< of the largest elements in the brightest light: first to be split as it is
  kCount
};

#if defined(FIXRAD_CHECKED)

/// How often each place has cut a number since the program began.
inline uint32_t place_counts[static_cast<int>(Place::kCount)] = {};

inline void count_cut(bool is_cut, Place place) {
  place_counts[static_cast<int>(place)] += is_cut ? 1u : 0u;
}

#else

inline void count_cut(bool, Place) {}

#endif

/// `a` in a narrower format that holds it.
template <class To, class From>
inline To narrow(From a, Place place) {
  const To cut = static_cast<To>(a);
#if defined(FIXRAD_CHECKED)
  count_cut(static_cast<int64_t>(cut) != static_cast<int64_t>(a), place);
#else
  static_cast<void>(place);
#endif
  return cut;
}

/// `a`, at most `most`.
template <class T>
inline uint32_t saturate(T a, Place place, uint32_t most = 0xfffffffful) {
  count_cut(a > most, place);
  return a > most ? most : static_cast<uint32_t>(a);
}

}  // namespace fixrad

// A function whose unsigned numbers are meant modulo a power of two: hashes, phases, two's complement.
// clang's check of that (FIXRAD_INTEGER_CHECKS) leaves it out.
#if defined(__clang__)
#define FIXRAD_MODULO \
  __attribute__((no_sanitize("unsigned-integer-overflow", "unsigned-shift-base", "implicit-conversion")))
#else
#define FIXRAD_MODULO
#endif

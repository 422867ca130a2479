// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/flash.h"
#include "lib/transport/state.h"

namespace fixrad {

/// What a solution must be, bit for bit, as the host has computed it. The tables are in flash.
struct ExpectedSolution {
  uint64_t digest;
  uint32_t shots;
  uint32_t eyes;
  const FIXRAD_FLASH int64_t (
      *ledger)[5];                       ///< [channel]: emitted, absorbed, unshot, escaped, back; flux units
  const FIXRAD_FLASH int32_t* received;  ///< [element][channel], flux units
};

enum class Disagreement : uint8_t {
  none,
  received,  ///< the received flux of an element
  vertices,  ///< the digest, though every received flux agrees: a vertex radiosity
  shots,
  eyes,
  ledger,  ///< a line of a channel's ledger
};

/// The first thing in which a solution is not the expected one.
struct Difference {
  Disagreement what;
  uint16_t element;  ///< for received
  uint8_t channel;   ///< for received and ledger
  uint8_t line;      ///< for ledger, 0 .. 4 in the order of ExpectedSolution
  int64_t found, wanted;
};

/// Compares `state`, whose digest the caller has computed, with what is expected: elements first, so that a
/// wrong bit is reported where it lies. For `vertices` found and wanted are the digests' bits. Cost: linear.
Difference compare(const State& state, uint64_t digest, const ExpectedSolution& expected);

}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "lib/fixrad.h"
#include "lib/save/checksum.h"

namespace fixrad::host {

/// A saved state in memory: sink and source. Must not move while they are in use.
struct Blob {
  std::vector<std::uint8_t> bytes;

  StateSink sink() {
    return {this, [](void* context, const std::uint8_t* from, std::uint8_t count) {
              auto& to = static_cast<Blob*>(context)->bytes;
              to.insert(to.end(), from, from + count);
              return true;
            }};
  }

  StateSource source() {
    return {this, [](void* context, std::uint32_t offset, std::uint8_t* to, std::uint8_t count) {
              const auto& from = static_cast<Blob*>(context)->bytes;
              if (offset > from.size() || from.size() - offset < count) {
                return false;
              }
              std::memcpy(to, from.data() + offset, count);
              return true;
            }};
  }

  /// The number of `count` bytes at `offset`.
  std::uint64_t number(std::size_t offset, std::size_t count) const {
    std::uint64_t value = 0;
    for (std::size_t i = count; i-- > 0;) {
      value = value << 8 | bytes[offset + i];
    }
    return value;
  }

  void set_number(std::size_t offset, std::size_t count, std::uint64_t value) {
    for (std::size_t i = 0; i < count; ++i, value >>= 8) {
      bytes[offset + i] = static_cast<std::uint8_t>(value);
    }
  }

  /// Makes the last four bytes the checksum of all before them.
  void seal() {
    Checksum sum;
    for (std::size_t i = 0; i + kChecksumBytes < bytes.size(); ++i) {
      sum.add(bytes[i]);
    }
    set_number(bytes.size() - kChecksumBytes, kChecksumBytes, sum.value());
  }
};

/// The state as it is saved; of a solver or anything else with a State.
inline Blob saved(const State& state, const Identity& identity, std::uint32_t sequence = 0) {
  Blob blob;
  save_state(state, identity, blob.sink(), sequence);
  return blob;
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace fixrad {
namespace device_test {

/// A linear congruential generator (Knuth's MMIX constants), the same numbers on every target.
class Random {
 public:
  explicit Random(uint32_t seed) : state_(seed) {}

  uint32_t bits() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<uint32_t>(state_ >> 32);
  }

  /// low..high, both included; high - low < 2^32 - 1.
  uint32_t between(uint32_t low, uint32_t high) { return low + bits() % (high - low + 1); }

 private:
  uint64_t state_;
};

}  // namespace device_test
}  // namespace fixrad

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fixrad::host {

/// Random numbers that depend on a key and a counter only, so that neither threads nor their order change a
/// result. SplitMix64: G. Steele, D. Lea, C. Flood, OOPSLA 2014.
class CounterRandom {
 public:
  /// A stream of its own for every (seed, major, minor).
  CounterRandom(std::uint64_t seed, std::uint64_t major, std::uint64_t minor)
      : state_(mix(mix(mix(seed + kStep) + major + kStep) + minor + kStep)) {}

  /// The next number of the stream, uniform in [0, 1), 53 bits.
  double next() { return static_cast<double>(next_bits() >> 11U) * 0x1p-53; }

  /// The next 64 bits of the stream.
  std::uint64_t next_bits() {
    state_ += kStep;
    return mix(state_);
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio, odd

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "firmware/apps/compare_expected.h"

namespace fixrad {
namespace {

Difference first_received(const State& state, const ExpectedSolution& expected) {
  const uint8_t channels = state.scene.channels;
  uint16_t index = 0;
  for (uint16_t e = 0; e < state.scene.element_count; ++e) {
    for (uint8_t c = 0; c < channels; ++c, ++index) {
      const int32_t found = state.received[index], wanted = flash_read(expected.received, index);
      if (found != wanted) {
        return {Disagreement::received, e, c, 0, found, wanted};
      }
    }
  }
  return {Disagreement::none, 0, 0, 0, 0, 0};
}

Difference first_ledger_line(const State& state, const ExpectedSolution& expected) {
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    const Ledger found = ledger(state, c);
    const int64_t lines[5] = {found.emitted, found.absorbed, found.unshot, found.escaped, found.back};
    for (uint8_t i = 0; i < 5; ++i) {
      const int64_t wanted = flash_read(&expected.ledger[c][0], i);
      if (lines[i] != wanted) {
        return {Disagreement::ledger, 0, c, i, lines[i], wanted};
      }
    }
  }
  return {Disagreement::none, 0, 0, 0, 0, 0};
}

}  // namespace

Difference compare(const State& state, uint64_t digest, const ExpectedSolution& expected) {
  const Difference received = first_received(state, expected);
  if (received.what != Disagreement::none) {
    return received;
  }
  if (digest != expected.digest) {
    return {
        Disagreement::vertices, 0, 0, 0, static_cast<int64_t>(digest), static_cast<int64_t>(expected.digest)};
  }
  if (state.shots != expected.shots) {
    return {Disagreement::shots, 0, 0, 0, state.shots, expected.shots};
  }
  if (state.eyes != expected.eyes) {
    return {Disagreement::eyes, 0, 0, 0, state.eyes, expected.eyes};
  }
  return first_ledger_line(state, expected);
}

}  // namespace fixrad

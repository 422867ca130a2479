// SPDX-License-Identifier: MIT
// The same with the engines that look at elements pair by pair, and the correction of near pairs.
#include "tests/fuzz/byte_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fixrad::fuzz::load_and_shoot(data, size, true);
  return 0;
}

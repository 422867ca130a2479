// SPDX-License-Identifier: MIT
// Scenes straight into the core: load() either refuses a scene and changes nothing, or every step after it is
// defined and keeps the ledger, whatever its tables hold. Engines of rows and pixels.
#include "tests/fuzz/byte_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fixrad::fuzz::load_and_shoot(data, size, false);
  return 0;
}

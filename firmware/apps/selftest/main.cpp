// SPDX-License-Identifier: MIT
// The tests of tests/device with the small header, on a board: exit code 0 if all passed.
#include "tests/device/small_test.h"

int main() {
  return fixrad::small_test::run_all();
}

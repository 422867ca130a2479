// SPDX-License-Identifier: MIT
// A library that prints.
extern "C" int printf(const char* format, ...);

namespace fixrad {

void print(int value) {
  printf("%d", value);
}

}  // namespace fixrad

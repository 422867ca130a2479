// SPDX-License-Identifier: MIT
// A call through a pointer that nobody has listed.
namespace fixrad {

int call(int (*function)(int), int value) {
  return function(value) + 1;
}

}  // namespace fixrad

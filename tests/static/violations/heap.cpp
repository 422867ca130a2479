// SPDX-License-Identifier: MIT
// A library that allocates.
namespace fixrad {

int* allocate(unsigned count) {
  return new int[count];
}

}  // namespace fixrad

// SPDX-License-Identifier: MIT
// A frame of known size, which is too large.
namespace fixrad {

int large(unsigned index) {
  volatile char values[5000];
  values[index] = 1;
  return values[0];
}

}  // namespace fixrad

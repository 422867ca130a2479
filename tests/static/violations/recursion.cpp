// SPDX-License-Identifier: MIT
// A function that calls itself through another one.
namespace fixrad {

__attribute__((noinline)) int odd(int n);

__attribute__((noinline)) int even(int n) {
  return n <= 0 ? n : odd(n - 2) * n + 1;
}

int odd(int n) {
  return n <= 0 ? n : even(n - 3) * n - 1;
}

}  // namespace fixrad

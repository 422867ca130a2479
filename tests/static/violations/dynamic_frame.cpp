// SPDX-License-Identifier: MIT
// A frame as large as an argument says.
namespace fixrad {

int last_of(unsigned count) {
  auto* values = static_cast<volatile char*>(__builtin_alloca(count));
  values[count - 1] = 1;
  return values[0];
}

}  // namespace fixrad

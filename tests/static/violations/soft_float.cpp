// SPDX-License-Identifier: MIT
// A library that computes in floating point: in single precision, which some cores have, and in double.
namespace fixrad {

float single_product(float a, float b) {
  return a * b;
}

double double_product(double a, double b) {
  return a * b;
}

}  // namespace fixrad

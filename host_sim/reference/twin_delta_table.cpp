// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_delta_table.h"

#include <cmath>

#include "host_sim/tables/delta_form_factors.h"

namespace fixrad::host {
namespace {

std::vector<double> half_rows(bool is_top, int half_size) {
  std::vector<double> sums;
  for (int r = 0; r < half_size; ++r) {
    for (int i = 0; i <= half_size; ++i) {
      sums.push_back(half_row_integral(is_top, 2 * half_size, r, static_cast<double>(i) / half_size));
    }
  }
  return sums;
}

double total(const std::vector<double>& sums, int half_size) {
  double sum = 0;
  for (std::size_t r = 1; r <= static_cast<std::size_t>(half_size); ++r) {
    sum += sums[r * static_cast<std::size_t>(half_size + 1) - 1];
  }
  return sum;
}

void scale(std::vector<double>& sums, double factor) {
  for (double& s : sums) {
    s *= factor;
  }
}

}  // namespace

double TwinDeltaRow::sum_to(double x) const {
  if (borders == nullptr) {
    return (0.5 + std::copysign(half_lune_integral(std::fabs(x)), x)) / (2 * half_size);
  }
  const double distance = std::fabs(x) * half_size;
  const int whole = static_cast<int>(distance);
  const int pixel = whole < half_size ? whole : half_size - 1;
  const double part = borders[pixel] + (borders[pixel + 1] - borders[pixel]) * (distance - pixel);
  return borders[half_size] + std::copysign(part, x);
}

// A half row of the top occurs four times (left and right, above and below the middle), one of a side eight
// times.
TwinDeltaTable::TwinDeltaTable(int resolution)
    : half_size_(resolution / 2), top_(half_rows(true, half_size_)), side_(half_rows(false, half_size_)) {
  const double sum = 4 * total(top_, half_size_) + 8 * total(side_, half_size_);
  scale(top_, 1 / sum);
  scale(side_, 1 / sum);
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace fixrad::host {

/// One row of a hemicube's side or top in double.
struct TwinDeltaRow {
  const double* borders;  ///< [half_size + 1], sums from the middle of the row to each pixel border
  int half_size;          ///< R/2

  double half_total() const { return borders[half_size]; }

  /// Running sum from the left end (x = -1) to x in [-1, 1]; linear within a pixel, as the core's is.
  double sum_to(double x) const {
    const double distance = std::fabs(x) * half_size;
    const int whole = static_cast<int>(distance);
    const int pixel = whole < half_size ? whole : half_size - 1;
    const double part = borders[pixel] + (borders[pixel + 1] - borders[pixel]) * (distance - pixel);
    return half_total() + std::copysign(part, x);
  }

  /// Delta form factor of pixel `p`, 0..R-1 from the left.
  double pixel(int p) const {
    const int from_middle = p >= half_size ? p - half_size : half_size - 1 - p;
    return borders[from_middle + 1] - borders[from_middle];
  }
};

/// Exact delta form factors of a hemicube of R x R pixels, as running sums along rows; top and four sides sum
/// to one within the rounding of double.
class TwinDeltaTable {
 public:
  /// R even. Cost: R^2/2 quadratures.
  explicit TwinDeltaTable(int resolution);

  /// Row `r` (0..R-1, bottom up) of the top, or of a side (R/2..R-1 only).
  TwinDeltaRow row(bool is_top, int r) const {
    const int from_middle = r >= half_size_ ? r - half_size_ : half_size_ - 1 - r;
    const std::vector<double>& sums = is_top ? top_ : side_;
    return {sums.data() + static_cast<std::ptrdiff_t>(from_middle) * (half_size_ + 1), half_size_};
  }

  int resolution() const { return 2 * half_size_; }

 private:
  int half_size_;
  std::vector<double> top_, side_;  // [R/2][R/2 + 1]
};

}  // namespace fixrad::host

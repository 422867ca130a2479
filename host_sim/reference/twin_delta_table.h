// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace fixrad::host {

/// One row of lunes, or of a hemicube's side or top, in double.
struct TwinDeltaRow {
  const double*
      borders;    ///< [half_size + 1], sums from the middle of the row to each pixel border; lunes: null
  int half_size;  ///< R/2

  /// Running sum from the left end (x = -1) to x in [-1, 1]. On a hemicube linear within a pixel, as the
  /// core's is; on a lune exact.
  double sum_to(double x) const;

  /// Delta form factor of pixel `p`, 0..R-1 from the left; hemicube only.
  double pixel(int p) const {
    const int from_middle = p >= half_size ? p - half_size : half_size - 1 - p;
    return borders[from_middle + 1] - borders[from_middle];
  }
};

/// Any of R lunes; x is the core's position u = s / (1 + |s|).
inline TwinDeltaRow twin_lune_delta_row(int resolution) {
  return {nullptr, resolution / 2};
}

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

 private:
  int half_size_;
  std::vector<double> top_, side_;  // [R/2][R/2 + 1]
};

}  // namespace fixrad::host

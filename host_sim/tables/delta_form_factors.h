// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace fixrad::host {

/// Exact delta form factors of a hemicube of R x R pixels, integrated over strips of a row, in double
/// precision. Row r counts from the middle of the top, or from the horizon of a side; row height y = (2r +
/// 1)/R, thickness 2/R. Density per area: top 1/(pi (x^2 + y^2 + 1)^2), side y/(pi (x^2 + y^2 + 1)^2) (Cohen
/// & Greenberg 1985). The integral runs from the middle of the row (x = 0) to x, exact in x, over the row's
/// exact thickness in y by Gauss-Legendre quadrature.
double half_row_integral(bool is_top, int resolution, int row, double x);

/// The committed integers of one table: [R/2][R/2] running sums for top and side in units of 2^-20, so
/// rounded that four times all top half rows plus eight times all side half rows is exactly 2^20.
struct DeltaTableData {
  std::vector<std::uint16_t> top, side;
};

/// Computes the table for R = 8, 16, 32, 64 or 128.
DeltaTableData make_delta_table(int resolution);

}  // namespace fixrad::host

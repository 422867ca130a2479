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

/// Form factor between the middle of a lune and u = s / (1 + s), over the form factor of the whole lune:
/// (atan s + s / (1 + s^2)) / pi, which is the integral of the cosine over half great circles
/// (docs/lunes.md).
double half_lune_integral(double u);

/// The committed half row of lunes: 256 running sums, units of 2^-16 of a whole row.
std::vector<std::uint16_t> make_lune_half_row();

/// Cosines, Q11, of the angles whose sines are (2r + 1) / R, r = 0 .. R/2 - 1.
std::vector<std::int16_t> make_lune_cosines(int resolution);

}  // namespace fixrad::host

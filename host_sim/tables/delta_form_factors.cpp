// SPDX-License-Identifier: MIT
#include "host_sim/tables/delta_form_factors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kOne = 1 << 20;

// Integral of dx / (x^2 + c^2)^2 from 0 to x.
double strip(double x, double c2) {
  const double c = std::sqrt(c2);
  return x / (2 * c2 * (x * x + c2)) + std::atan(x / c) / (2 * c2 * c);
}

struct HalfRow {
  std::uint16_t* entries;
  double exact_total;
  int weight;  // how often the half row occurs: 4 on the top, 8 on the sides
  long total;
};

// Rounds every half-row total and then moves single units where the rounding was closest to a tie, until the
// weighted sum is exactly one. All weights and the total are multiples of four.
void make_exact(std::vector<HalfRow>& rows) {
  long sum = 0;
  for (HalfRow& row : rows) {
    row.total = std::lround(row.exact_total * kOne);
    sum += row.weight * row.total;
  }
  const long step = sum < static_cast<long>(kOne) ? 1 : -1;
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto gain = [&](std::size_t i) {
    return static_cast<double>(step) * (rows[i].exact_total * kOne - static_cast<double>(rows[i].total));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return gain(a) > gain(b); });
  for (std::size_t k = 0; sum != static_cast<long>(kOne); k = (k + 1) % order.size()) {
    HalfRow& row = rows[order[k]];
    if (std::labs(static_cast<long>(kOne) - sum) >= row.weight) {
      row.total += step;
      sum += step * row.weight;
    }
  }
}

}  // namespace

double half_row_integral(bool is_top, int resolution, int row, double x) {
  // Five-point Gauss-Legendre over the thickness; the integrand is analytic and the strip thin.
  static constexpr double kNode[5] = {0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                                      -0.9061798459386640};
  static constexpr double kWeight[5] = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                        0.2369268850561891, 0.2369268850561891};
  const double half = 1.0 / resolution;
  double sum = 0;
  for (int i = 0; i < 5; ++i) {
    const double y = (2 * row + 1) * half + kNode[i] * half;
    sum += kWeight[i] * half * strip(x, y * y + 1) * (is_top ? 1.0 : y) / kPi;
  }
  return sum;
}

DeltaTableData make_delta_table(int resolution) {
  const int half = resolution / 2;
  const auto size = static_cast<std::size_t>(half) * static_cast<std::size_t>(half);
  DeltaTableData data{std::vector<std::uint16_t>(size), std::vector<std::uint16_t>(size)};
  std::vector<HalfRow> rows;
  for (int r = 0; r < half; ++r) {
    rows.push_back({data.top.data() + r * half, half_row_integral(true, resolution, r, 1.0), 4, 0});
    rows.push_back({data.side.data() + r * half, half_row_integral(false, resolution, r, 1.0), 8, 0});
  }
  make_exact(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_top = i % 2 == 0;
    for (int p = 0; p < half; ++p) {
      const double part = half_row_integral(is_top, resolution, static_cast<int>(i / 2), (p + 1.0) / half);
      const double scaled = part / rows[i].exact_total * static_cast<double>(rows[i].total);
      rows[i].entries[p] = static_cast<std::uint16_t>(std::lround(scaled));
    }
  }
  return data;
}

double half_lune_integral(double u) {
  if (u >= 1.0) {
    return 0.5;
  }
  const double tangent = u / (1.0 - u);
  return (std::atan(tangent) + tangent / (1.0 + tangent * tangent)) / kPi;
}

std::vector<std::uint16_t> make_lune_half_row() {
  constexpr int kParts = 256;
  std::vector<std::uint16_t> entries;
  for (int i = 1; i <= kParts; ++i) {
    const double sum = half_lune_integral(static_cast<double>(i) / kParts);
    entries.push_back(static_cast<std::uint16_t>(std::lround(std::ldexp(sum, 16))));
  }
  return entries;
}

std::vector<std::int16_t> make_lune_cosines(int resolution) {
  std::vector<std::int16_t> cosines;
  for (int r = 0; r < resolution / 2; ++r) {
    const double sine = (2.0 * r + 1.0) / resolution;
    cosines.push_back(static_cast<std::int16_t>(std::lround(std::ldexp(std::sqrt(1.0 - sine * sine), 11))));
  }
  return cosines;
}

}  // namespace fixrad::host

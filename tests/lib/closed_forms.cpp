// SPDX-License-Identifier: MIT
#include "tests/lib/closed_forms.h"

#include <cmath>

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;

// The alternating sum over the 16 combinations of limits, over 2 pi and the area of `from`.
template <class Primitive>
double alternating_sum(const Rectangle& from, const Rectangle& to, const Primitive& primitive) {
  double sum = 0;
  for (int bits = 0; bits < 16; ++bits) {
    const double x = (bits & 1) != 0 ? from.x1 : from.x0, y = (bits & 2) != 0 ? from.y1 : from.y0;
    const double xi = (bits & 4) != 0 ? to.x1 : to.x0, eta = (bits & 8) != 0 ? to.y1 : to.y0;
    const int ones = (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1) + (bits >> 3 & 1);
    sum += (ones % 2 == 0 ? 1.0 : -1.0) * primitive(x, y, xi, eta);
  }
  return sum / (2 * kPi * (from.x1 - from.x0) * (from.y1 - from.y0));
}

double times_log(double factor, double argument) {
  return argument > 0 ? factor * std::log(argument) : 0.0;
}

// Rectangle from the point's foot to (x, y).
double corner_factor(double x, double y, double z) {
  const double a = std::sqrt(x * x + z * z), b = std::sqrt(y * y + z * z);
  return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2 * kPi);
}

}  // namespace

double parallel_form_factor(const Rectangle& from, const Rectangle& to, double z) {
  return alternating_sum(from, to, [z](double x, double y, double xi, double eta) {
    const double u = x - xi, v = y - eta;
    const double a = std::sqrt(u * u + z * z), b = std::sqrt(v * v + z * z);
    return v * a * std::atan(v / a) + u * b * std::atan(u / b) - z * z / 2 * std::log(u * u + v * v + z * z);
  });
}

double perpendicular_form_factor(const Rectangle& from, const Rectangle& to) {
  return alternating_sum(from, to, [](double x, double y, double xi, double eta) {
    const double r2 = x * x + xi * xi, v = y - eta;
    const double r = std::sqrt(r2);
    return (r > 0 ? v * r * std::atan(v / r) : 0.0) - times_log((r2 - v * v) / 4, r2 + v * v);
  });
}

double point_to_parallel(const Rectangle& to, double z) {
  return corner_factor(to.x1, to.y1, z) - corner_factor(to.x0, to.y1, z) - corner_factor(to.x1, to.y0, z) +
         corner_factor(to.x0, to.y0, z);
}

std::array<double, 3> cube_radiosity(double reflectance, double opposite, double adjacent) {
  double emitter = 1, far = 0, side = 0;
  for (int i = 0; i < 20000; ++i) {
    emitter = 1 + reflectance * (opposite * far + 4 * adjacent * side);
    far = reflectance * (opposite * emitter + 4 * adjacent * side);
    side = reflectance * (adjacent * (emitter + far) + (opposite + 2 * adjacent) * side);
  }
  return {emitter, far, side};
}

RefinedCube::RefinedCube(int n) : n_(n) {
  const double h = 1.0 / n;
  const int count = n * n;
  for (int i = 0; i < count; ++i) {
    const Rectangle from = {i / n * h, (i / n + 1) * h, i % n * h, (i % n + 1) * h};
    for (int j = 0; j < count; ++j) {
      const Rectangle to = {j / n * h, (j / n + 1) * h, j % n * h, (j % n + 1) * h};
      opposite_.push_back(parallel_form_factor(from, to, 1.0));
      adjacent_.push_back(perpendicular_form_factor(from, to));
    }
  }
}

// The four sides are turned copies of one another and every field is symmetric about the middle, so three
// fields say all: by distance from a common line and position along it.
std::array<double, 3> RefinedCube::face_means(double reflectance) const {
  const int count = n_ * n_;
  const auto size = static_cast<std::size_t>(count);
  std::vector<double> emitter(size, 1.0), far(size, 0.0), side(size, 0.0);
  // A side seen from the far face, and from its neighbour across a vertical line.
  std::vector<double> flipped(size), upright(size);
  const auto gather = [&](const std::vector<double>& factors, int x, int y, const std::vector<double>& from) {
    const double* row = factors.data() + static_cast<std::size_t>(x * n_ + y) * size;
    double sum = 0;
    for (std::size_t j = 0; j < size; ++j) {
      sum += row[j] * from[j];
    }
    return sum;
  };
  double change = 1;
  while (change > 1e-7) {
    change = 0;
    for (int i = 0; i < count; ++i) {
      upright[static_cast<std::size_t>(i % n_ * n_ + i / n_)] = side[static_cast<std::size_t>(i)];
      flipped[static_cast<std::size_t>((n_ - 1 - i / n_) * n_ + i % n_)] = side[static_cast<std::size_t>(i)];
    }
    for (int i = 0; i < count; ++i) {
      const int x = i / n_, y = i % n_, last = n_ - 1;
      const auto at = static_cast<std::size_t>(i);
      const auto from_sides = [&](const std::vector<double>& field) {
        return gather(adjacent_, x, y, field) + gather(adjacent_, last - x, y, field) +
               gather(adjacent_, y, x, field) + gather(adjacent_, last - y, x, field);
      };
      emitter[at] = 1 + reflectance * (gather(opposite_, x, y, far) + from_sides(side));
      far[at] = reflectance * (gather(opposite_, x, y, emitter) + from_sides(flipped));
    }
    for (int i = 0; i < count; ++i) {
      const int x = i / n_, y = i % n_, last = n_ - 1;
      const auto at = static_cast<std::size_t>(i);
      const double renewed =
          reflectance * (gather(adjacent_, x, y, emitter) + gather(adjacent_, last - x, y, far) +
                         gather(opposite_, x, y, side) + gather(adjacent_, y, x, upright) +
                         gather(adjacent_, last - y, x, upright));
      change += (renewed > side[at] ? renewed - side[at] : side[at] - renewed) / count;
      side[at] = renewed;
    }
  }
  const auto mean = [&](const std::vector<double>& field) {
    double sum = 0;
    for (const double b : field) {
      sum += b;
    }
    return sum / count;
  };
  return {mean(emitter), mean(far), mean(side)};
}

}  // namespace fixrad::host

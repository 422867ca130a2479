// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace fixrad::host {

/// A rectangle's range along its two axes.
struct Rectangle {
  double x0, x1, y0, y1;
};

/// Form factor between parallel rectangles a distance z apart, area averaged over `from` (Ehlert & Smith
/// 1993, "View factors for perpendicular and parallel rectangular plates").
double parallel_form_factor(const Rectangle& from, const Rectangle& to, double z);

/// Form factor between perpendicular rectangles, area averaged over `from`, same source. `from` lies in the
/// plane z = 0 with x its distance from the common line, y along it; `to` lies in the plane x = 0 with its x
/// the height over the line.
double perpendicular_form_factor(const Rectangle& from, const Rectangle& to);

/// Form factor from a point to a parallel rectangle a distance z above it; coordinates relative to the point.
double point_to_parallel(const Rectangle& to, double z);

/// Radiosity of the unit cube's faces (emitter, opposite, side) with one face emitting 1, each face of
/// uniform radiosity, from the factors to the opposite and an adjacent face.
std::array<double, 3> cube_radiosity(double reflectance, double opposite, double adjacent);

/// Mean radiosity of the unit cube's faces (emitter, opposite, mean side) with one face emitting 1, solved in
/// double on n x n elements a face with closed-form factors.
class RefinedCube {
 public:
  explicit RefinedCube(int n);
  std::array<double, 3> face_means(double reflectance) const;

 private:
  int n_;
  std::vector<double> opposite_;  // [n n][n n], between elements of opposite faces
  std::vector<double> adjacent_;  // the same of adjacent faces, y along the common edge
};

constexpr double kParallelUnitSquares = 0.19982489569838746;
constexpr double kPerpendicularUnitSquares = 0.20004377607540316;

}  // namespace fixrad::host

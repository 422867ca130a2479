// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace fixrad::host {

/// Maps the unit square onto a convex polygon so that equal areas stay equal: stratified (u, v) give
/// stratified points. u, v in [0, 1].
glm::dvec3 sample_polygon(const std::vector<glm::dvec3>& polygon, double u, double v);

/// sample_polygon() for many samples of one polygon: a parallelogram costs two products of vectors, others a
/// search through their corners and a square root.
class PolygonSampler {
 public:
  /// @param polygon  convex, 3 corners or more; copied
  explicit PolygonSampler(const std::vector<glm::dvec3>& polygon);

  glm::dvec3 sample(double u, double v) const;

 private:
  std::vector<glm::dvec3> corners_;
  std::vector<double> cumulative_;  ///< doubled area of the fan's triangles so far; empty for a parallelogram
};

/// A point of a quadrature rule; the weights of a rule add up to the area that it covers.
struct QuadraturePoint {
  glm::dvec3 position{0.0};
  double weight = 0.0;  ///< area, scene units squared
};

/// A square cell [u, u + size] x [v, v + size] of the bilinear map of a quadrilateral, to be split in four.
/// A triangle is a quadrilateral with its last corner twice.
struct QuadratureCell {
  std::array<glm::dvec3, 4> corners;
  double u = 0.0;
  double v = 0.0;
  double size = 1.0;

  /// Gauss-Legendre rule of 2 x 2 points: exact for cubic integrands on a parallelogram.
  std::array<QuadraturePoint, 4> points() const;
  std::array<QuadratureCell, 4> split() const;
};

/// The cells that tile a convex polygon: one for 3 or 4 corners, a fan of them for more.
std::vector<QuadratureCell> quadrature_cells(const std::vector<glm::dvec3>& polygon);

}  // namespace fixrad::host

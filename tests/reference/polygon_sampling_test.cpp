// SPDX-License-Identifier: MIT
#include "host_sim/reference/polygon_sampling.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

using Polygon = std::vector<glm::dvec3>;

const Polygon kHexagon{{0, 0, 1}, {2, 0, 1}, {3, 1, 1}, {2, 2, 1}, {0, 2, 1}, {-1, 1, 1}};
const Polygon kTriangle{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
const Polygon kTrapezium{{0, 0, 0}, {4, 0, 0}, {3, 2, 0}, {1, 2, 0}};

glm::dvec3 mean_sample(const Polygon& polygon, int steps) {
  glm::dvec3 sum{0.0};
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      sum += sample_polygon(polygon, (i + 0.5) / steps, (j + 0.5) / steps);
    }
  }
  return sum / static_cast<double>(steps * steps);
}

TEST(PolygonSampling, KeepsAreasSoThatTheMeanOfTheSamplesIsTheCentroid) {
  EXPECT_LT(glm::distance(mean_sample(kHexagon, 300), {1, 1, 1}), 1e-2);
  EXPECT_LT(glm::distance(mean_sample(kTriangle, 300), {2.0 / 3.0, 1.0, 0.0}), 1e-3);
  EXPECT_LT(glm::distance(mean_sample(kTrapezium, 300), {2.0, 8.0 / 9.0, 0.0}), 1e-2);
}

TEST(PolygonSampling, QuadratureWeightsAddUpToTheArea) {
  const auto area = [](const Polygon& polygon) {
    double sum = 0.0;
    for (const QuadratureCell& cell : quadrature_cells(polygon)) {
      for (const QuadratureCell& child : cell.split()) {
        for (const QuadraturePoint& point : child.points()) {
          sum += point.weight;
        }
      }
    }
    return sum;
  };
  EXPECT_NEAR(area(kHexagon), 6.0, 1e-12);
  EXPECT_NEAR(area(kTriangle), 3.0, 1e-12);
  EXPECT_NEAR(area(kTrapezium), 6.0, 1e-12);
}

TEST(PolygonSampling, QuadratureIsExactForCubicsOnARectangle) {
  const Polygon rectangle{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  double sum = 0.0;
  for (const QuadraturePoint& point : quadrature_cells(rectangle).front().points()) {
    const glm::dvec3& p = point.position;
    sum += point.weight * p.x * p.x * p.x * p.y * p.y;
  }
  EXPECT_NEAR(sum, 4.0 / 3.0, 1e-13);
}

}  // namespace
}  // namespace fixrad::host

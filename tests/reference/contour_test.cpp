// SPDX-License-Identifier: MIT
#include "host_sim/reference/contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/reference/counter_random.h"
#include "host_sim/reference/polygon_sampling.h"

namespace fixrad::host {
namespace {

using Polygon = std::vector<glm::dvec3>;

constexpr double kPi = 3.141592653589793;
const glm::dvec3 kUp{0, 0, 1};

/// Parallel rectangle a x b at distance c, one corner straight above the point (Siegel and Howell, B-3).
double corner_formula(double a, double b, double c) {
  const double ra = std::hypot(a, c);
  const double rb = std::hypot(b, c);
  return (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb)) / (2.0 * kPi);
}

/// The definition: integral of cos cos / (pi r^2) over a parallelogram, midpoint rule.
double numerical_form_factor(const glm::dvec3& point, const glm::dvec3& normal, const Polygon& polygon,
                             int steps) {
  const glm::dvec3 u = polygon[1] - polygon[0];
  const glm::dvec3 v = polygon[3] - polygon[0];
  const glm::dvec3 area = glm::cross(u, v);
  double sum = 0.0;
  for (int row = 0; row < steps; ++row) {
    for (int column = 0; column < steps; ++column) {
      const glm::dvec3 sight = polygon[0] + (column + 0.5) / steps * u + (row + 0.5) / steps * v - point;
      const double square = glm::dot(sight, sight);
      sum +=
          std::max(0.0, glm::dot(sight, normal)) * std::max(0.0, -glm::dot(sight, area)) / (square * square);
    }
  }
  return sum / (kPi * steps * steps);
}

glm::dvec3 random_vector(CounterRandom& random) {
  return {2.0 * random.next() - 1.0, 2.0 * random.next() - 1.0, 2.0 * random.next() - 1.0};
}

TEST(Contour, MatchesTheCornerFormulaOfAParallelRectangle) {
  for (const double a : {0.01, 0.5, 1.0, 20.0}) {
    for (const double c : {0.001, 0.3, 1.0, 10.0}) {
      const Polygon rectangle{{0, 0, c}, {0, 1, c}, {a, 1, c}, {a, 0, c}};
      const double expected = corner_formula(a, 1.0, c);
      EXPECT_NEAR(point_to_polygon({0, 0, 0}, kUp, rectangle), expected, 1e-13) << a << ' ' << c;
    }
  }
}

TEST(Contour, AgreesWithNumericalQuadratureForOffsetAndTiltedPolygons) {
  CounterRandom random(1, 0, 0);
  int seen = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const glm::dvec3 normal = glm::normalize(random_vector(random));
    const glm::dvec3 corner = 3.0 * random_vector(random);
    const glm::dvec3 u = random_vector(random);
    const glm::dvec3 v = random_vector(random);
    const Polygon polygon{corner, corner + u, corner + u + v, corner + v};
    const double expected = numerical_form_factor({0, 0, 0}, normal, polygon, 400);
    EXPECT_NEAR(point_to_polygon({0, 0, 0}, normal, polygon), expected, 1e-5 + 1e-3 * expected) << trial;
    seen += expected > 0.0 ? 1 : 0;
  }
  EXPECT_GT(seen, 5);
}

TEST(Contour, CountsOnlyWhatRisesAboveTheHorizon) {
  // A wall at x = 1 that straddles the horizon counts as its upper half does.
  const Polygon whole{{1, -1, -2}, {1, -1, 2}, {1, 1, 2}, {1, 1, -2}};
  const Polygon upper{{1, -1, 0}, {1, -1, 2}, {1, 1, 2}, {1, 1, 0}};
  const double expected = numerical_form_factor({0, 0, 0}, kUp, upper, 1000);
  EXPECT_NEAR(point_to_polygon({0, 0, 0}, kUp, whole), expected, 1e-6);
  EXPECT_NEAR(point_to_polygon({0, 0, 0}, kUp, upper), expected, 1e-6);
}

TEST(Contour, AddsUpOverThePartsOfAPolygon) {
  const Polygon whole{{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}};
  const Polygon left{{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}};
  const Polygon right{{-1, -1, 1}, {1, 1, 1}, {1, -1, 1}};
  const glm::dvec3 point{0.3, -0.7, 0.2};
  const glm::dvec3 normal = glm::normalize(glm::dvec3{1.0, 0.5, 0.1});
  EXPECT_NEAR(point_to_polygon(point, normal, whole),
              point_to_polygon(point, normal, left) + point_to_polygon(point, normal, right), 1e-14);
}

TEST(Contour, HandlesAConcavePolygonThatCrossesTheHorizonTwice) {
  // A comb at x = 1, lit side towards -x, whose two teeth rise above z = 0.
  const Polygon comb{{1, -2, -1},  {1, -2, 1}, {1, -1, 1}, {1, -1, -0.5},
                     {1, 1, -0.5}, {1, 1, 1},  {1, 2, 1},  {1, 2, -1}};
  const Polygon tooth_a{{1, -2, 0}, {1, -2, 1}, {1, -1, 1}, {1, -1, 0}};
  const Polygon tooth_b{{1, 1, 0}, {1, 1, 1}, {1, 2, 1}, {1, 2, 0}};
  const glm::dvec3 origin{0.0};
  const double teeth = point_to_polygon(origin, kUp, tooth_a) + point_to_polygon(origin, kUp, tooth_b);
  EXPECT_GT(teeth, 0.01);
  EXPECT_NEAR(point_to_polygon(origin, kUp, comb), teeth, 1e-14);
}

TEST(Contour, IsZeroBehindEitherPlane) {
  const Polygon above{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
  const Polygon turned{above.rbegin(), above.rend()};
  EXPECT_EQ(point_to_polygon({0, 0, 0}, -kUp, above), 0.0);
  EXPECT_EQ(point_to_polygon({0, 0, 0}, kUp, turned), 0.0);
  EXPECT_GT(point_to_polygon({0, 0, 0}, kUp, above), 0.1);
}

TEST(Contour, IsZeroInThePolygonsOwnPlaneAndOneCloseToItsInside) {
  const Polygon floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(point_to_polygon({0.5, 0.5, 0.0}, -kUp, floor), 0.0);
  EXPECT_EQ(point_to_polygon({2.0, 0.5, 0.0}, kUp, floor), 0.0);
  EXPECT_NEAR(point_to_polygon({0.5, 0.5, 1e-9}, -kUp, floor), 1.0, 1e-8);
}

TEST(Contour, TendsToOneHalfAtTheFootOfAWall) {
  const Polygon wall{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
  for (const double distance : {1e-4, 1e-7, 1e-10}) {
    EXPECT_NEAR(point_to_polygon({distance, 0.5, 0.0}, kUp, wall), 0.5, 3.0 * distance + 1e-12);
  }
}

TEST(Contour, StaysFiniteOnEdgesAndCorners) {
  const Polygon wall{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
  for (const glm::dvec3& point : {glm::dvec3{0, 0, 0}, glm::dvec3{0, 0.5, 0}, glm::dvec3{0, 1, 1}}) {
    const double value = point_to_polygon(point, kUp, wall);
    EXPECT_GE(value, 0.0);
    EXPECT_LE(value, 1.0);
  }
}

}  // namespace
}  // namespace fixrad::host

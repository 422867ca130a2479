// SPDX-License-Identifier: MIT
// Lambert's contour formula in fixed point against the same in double, and against closed forms.
#include "lib/form_factor/contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host_sim/reference/contour.h"
#include "tests/lib/closed_forms.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

Vec3 to_fine(const glm::dvec3& grid_point) {
  const glm::dvec3 p = glm::round(grid_point * static_cast<double>(kFineScale));
  return {static_cast<int32_t>(p.x), static_cast<int32_t>(p.y), static_cast<int32_t>(p.z)};
}

Polygon to_polygon(const std::vector<glm::dvec3>& corners) {
  Polygon polygon = {};
  for (const glm::dvec3& p : corners) {
    polygon.corner[polygon.count++] = to_fine(p);
  }
  return polygon;
}

ContourPoint point_at(const glm::dvec3& grid_point, const glm::dvec3& normal) {
  const glm::dvec3 n = glm::round(glm::normalize(normal) * 16384.0);
  fixrad::Face face = {};
  for (int k = 0; k < 3; ++k) {
    face.normal[k] = static_cast<int16_t>(n[k]);
  }
  return contour_point(face, to_fine(grid_point));
}

double factor(const ContourPoint& point, const Polygon& polygon) {
  return std::ldexp(contour_factor(point, polygon), -kArcBits);
}

double exact_factor(const ContourPoint& point, const Polygon& polygon) {
  const auto to_double = [](const Vec3& a) { return glm::dvec3(a.x, a.y, a.z); };
  std::vector<glm::dvec3> corners;
  for (int k = 0; k < polygon.count; ++k) {
    corners.push_back(to_double(polygon.corner[k]));
  }
  return point_to_polygon(to_double(point.position), glm::normalize(to_double(point.normal)), corners);
}

glm::dvec3 random_point(Random& random, double low, double high) {
  const double x = random.real(low, high), y = random.real(low, high), z = random.real(low, high);
  return {x, y, z};
}

// A regular polygon of `corners`, `size` across; two of its corners may lie under any horizon.
Polygon random_polygon(Random& random, int corners, double size) {
  const glm::dvec3 middle = random_point(random, size, 16383 - size);
  const glm::dvec3 n = glm::normalize(random_point(random, -1, 1) + glm::dvec3(1e-3));
  const glm::dvec3 u =
      glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 v = glm::cross(n, u);
  std::vector<glm::dvec3> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * 3.14159265358979 * k / corners;
    points.push_back(middle + size / 2 * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return to_polygon(points);
}

// Largest |error| over random eyes and polygons of this size.
double largest_error(double size, std::uint32_t seed) {
  Random random(seed);
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const Polygon polygon = random_polygon(random, random.between(3, 8), size);
    const ContourPoint point = point_at(random_point(random, 0, 16383), random_point(random, -1, 1));
    const double exact = exact_factor(point, polygon);
    const double fixed = factor(point, polygon);
    // Seen from behind the double gives 0 and the core the negative.
    largest = std::max(largest, exact > 0 ? std::abs(fixed - exact) : std::max(0.0, fixed));
  }
  return largest;
}

TEST(Contour, OfPolygonsOfAnySizeIsWithinTheStatedErrorOfDouble) {
  struct Bound {
    double size, error;
  };
  std::uint32_t seed = 1;
  // The largest reach so near to their eyes that edges span almost half a turn.
  for (const Bound bound : {Bound{10, 0x1p-25}, {100, 0x1p-25}, {1000, 0x1p-24}, {8000, 0x1p-19}}) {
    const double error = largest_error(bound.size, seed++);
    RecordProperty("log2_error_of_size_" + std::to_string(static_cast<int>(bound.size)),
                   std::to_string(std::log2(error)));
    EXPECT_LT(error, bound.error) << "size " << bound.size;
  }
}

TEST(Contour, OfAParallelSquareIsTheTextbookFactor) {
  constexpr double kBound = 0x1p-22;
  for (const double height : {10.0, 100.0, 1000.0, 10000.0}) {
    const Polygon above = to_polygon({{1000, 5000 + height, 1000},
                                      {9000, 5000 + height, 1000},
                                      {9000, 5000 + height, 9000},
                                      {1000, 5000 + height, 9000}});
    const ContourPoint point = point_at({3000, 5000, 4000}, {0, 1, 0});
    EXPECT_NEAR(factor(point, above), point_to_parallel({-2000, 6000, -3000, 5000}, height), kBound)
        << height;
  }
}

// A long wall of height h at distance x, from a point on the floor: F = (1 - x / sqrt(x^2 + h^2)) / 2.
TEST(Contour, OfAWallThatTouchesTheFloorIsTheTwoDimensionalFactor) {
  constexpr double kHeight = 40, kLength = 16383;
  constexpr double kEnds = 1e-5;  // what the wall lacks of infinity: (height / length)^2 and less
  const Polygon wall =
      to_polygon({{8000, 0, kLength}, {8000, kHeight, kLength}, {8000, kHeight, 0}, {8000, 0, 0}});
  for (const double x : {1.0, 4.0, 30.0}) {
    const ContourPoint point = point_at({8000 - x, 0, kLength / 2}, {0, 1, 0});
    EXPECT_NEAR(factor(point, wall), (1 - x / std::hypot(x, kHeight)) / 2, kEnds) << x;
  }
}

TEST(Contour, OfTheBackIsTheNegative) {
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const Polygon front = random_polygon(random, random.between(3, 8), 3000);
    Polygon back = front;
    std::reverse(back.corner, back.corner + back.count);
    const ContourPoint point = point_at(random_point(random, 0, 16383), random_point(random, -1, 1));
    ASSERT_NEAR(factor(point, back), -factor(point, front), 0x1p-24);
  }
}

TEST(Contour, BelowTheHorizonIsNothing) {
  const Polygon below = to_polygon({{1000, 99, 1000}, {5000, 99, 1000}, {5000, 20, 5000}});
  EXPECT_EQ(contour_factor(point_at({2000, 100, 2000}, {0, 1, 0}), below), 0);
}

TEST(Contour, PartsOfAPolygonAddUpToTheWhole) {
  constexpr double kBound = 0x1p-24;
  Random random(9);
  for (int i = 0; i < 2000; ++i) {
    const Polygon whole = random_polygon(random, 8, 6000);
    Polygon first = {}, second = {};
    for (int k = 0; k < 5; ++k) {
      first.corner[first.count++] = whole.corner[k];
      second.corner[second.count++] = whole.corner[(k + 4) % 8];
    }
    const ContourPoint point = point_at(random_point(random, 0, 16383), random_point(random, -1, 1));
    ASSERT_NEAR(factor(point, first) + factor(point, second), factor(point, whole), kBound);
  }
}

}  // namespace
}  // namespace fixrad::host

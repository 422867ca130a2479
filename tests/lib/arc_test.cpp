// SPDX-License-Identifier: MIT
// Directions and angles in fixed point against double.
#include "lib/form_factor/arc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;

glm::dvec3 to_double(const Vec3& a) {
  return {std::ldexp(a.x, -kArcBits), std::ldexp(a.y, -kArcBits), std::ldexp(a.z, -kArcBits)};
}

Vec3 to_fixed(const glm::dvec3& a) {
  return {static_cast<int32_t>(std::lround(std::ldexp(a.x, kArcBits))),
          static_cast<int32_t>(std::lround(std::ldexp(a.y, kArcBits))),
          static_cast<int32_t>(std::lround(std::ldexp(a.z, kArcBits)))};
}

glm::dvec3 random_direction(Random& random) {
  for (;;) {
    const double x = random.real(-1, 1), y = random.real(-1, 1), z = random.real(-1, 1);
    const glm::dvec3 d(x, y, z);
    if (glm::length(d) > 0.1 && glm::length(d) < 1) {
      return glm::normalize(d);
    }
  }
}

// What edge_term() is to return, in double; the product's length is that of the sine.
double exact_term(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& n) {
  const glm::dvec3 wedge = glm::cross(a, b);
  const double sine = glm::length(wedge);
  return sine == 0 ? 0 : std::atan2(sine, glm::dot(a, b)) * glm::dot(wedge, n) / sine;
}

double largest_term_error(double smallest_angle, double largest_angle, std::uint32_t seed) {
  Random random(seed);
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 n = random_direction(random), a = random_direction(random);
    const glm::dvec3 side = glm::normalize(glm::cross(a, random_direction(random)));
    const double angle = random.real(smallest_angle, largest_angle);
    const Vec3 fixed_a = to_fixed(a), fixed_n = to_fixed(n);
    const Vec3 fixed_b = to_fixed(std::cos(angle) * a + std::sin(angle) * side);
    const double exact = exact_term(glm::normalize(to_double(fixed_a)), glm::normalize(to_double(fixed_b)),
                                    to_double(fixed_n));
    const double term = std::ldexp(edge_term(fixed_a, fixed_b, fixed_n), -kAngleBits);
    largest = std::max(largest, std::abs(term - exact));
  }
  return largest;
}

TEST(Arc, InverseRootIsWithinItsStatedError) {
  constexpr double kBound = 0x1p-27;
  for (std::uint64_t a = 1ull << 30; a < 1ull << 32; a += 98765) {
    const double exact = 1 / std::sqrt(std::ldexp(static_cast<double>(a), -32));
    const double y = std::ldexp(inverse_root(static_cast<std::uint32_t>(a)), -kArcBits);
    ASSERT_NEAR(y, exact, kBound) << a;
  }
  EXPECT_NEAR(std::ldexp(inverse_root(0xffffffffu), -kArcBits), 1.0, kBound);
  EXPECT_NEAR(std::ldexp(inverse_root(0x40000000u), -kArcBits), 2.0, kBound);
}

TEST(Arc, UnitVectorsPointWhereTheirArgumentsDo) {
  constexpr double kBound = 0x1p-26;
  Random random(1);
  for (int i = 0; i < 50000; ++i) {
    const double scale = std::ldexp(1.0, random.between(8, 31)) - 1;
    const glm::dvec3 d = random_direction(random) * scale;
    const Vec3 a = {static_cast<int32_t>(d.x), static_cast<int32_t>(d.y), static_cast<int32_t>(d.z)};
    const glm::dvec3 exact = glm::normalize(glm::dvec3(a.x, a.y, a.z));
    const glm::dvec3 unit = to_double(unit_vector(a));
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(unit[k], exact[k], kBound);
    }
  }
}

TEST(Arc, AxesAreTheirOwnUnitVectorsAndZeroStaysZero) {
  const Vec3 x = unit_vector({7, 0, 0});
  EXPECT_NEAR(x.x, kArcOne, 16);
  EXPECT_EQ(x.y, 0);
  EXPECT_EQ(x.z, 0);
  const Vec3 zero = unit_vector({0, 0, 0});
  EXPECT_EQ(max_magnitude(zero), 0u);
}

TEST(Arc, AngleOverSineIsWithinItsStatedError) {
  constexpr double kBound = 0x1p-24;
  for (int32_t c = 0; c < kArcOne; c += 54321) {
    const double angle = std::acos(std::ldexp(c, -kArcBits));
    ASSERT_NEAR(std::ldexp(angle_over_sine(c), -kArcBits), angle / std::sin(angle), kBound) << c;
  }
  EXPECT_NEAR(std::ldexp(angle_over_sine(0), -kArcBits), kPi / 2, kBound);
  EXPECT_NEAR(std::ldexp(angle_over_sine(kArcOne), -kArcBits), 1.0, kBound);
}

TEST(Arc, EdgeTermsOfSmallAnglesKeepTheirDigits) {
  EXPECT_LT(largest_term_error(1e-6, 0.02, 2), 0x1p-25);
}

TEST(Arc, EdgeTermsUpToAStraightAngleAreWithinTheirStatedError) {
  EXPECT_LT(largest_term_error(0.02, kPi / 2, 3), 0x1p-22);
  EXPECT_LT(largest_term_error(kPi / 2, kPi - 0x1p-7, 4), 0x1p-18);
}

TEST(Arc, AnEdgeRunBackwardsGivesTheNegative) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = to_fixed(random_direction(random)), b = to_fixed(random_direction(random));
    const Vec3 n = to_fixed(random_direction(random));
    if (glm::dot(to_double(a), to_double(b)) > -0.99) {
      ASSERT_NEAR(edge_term(a, b, n), -edge_term(b, a, n), 32);
    }
  }
}

TEST(Arc, EdgesWithoutLengthGiveNothing) {
  const Vec3 a = to_fixed(glm::normalize(glm::dvec3(1, 2, 3)));
  const Vec3 n = to_fixed(glm::normalize(glm::dvec3(-1, 5, 2)));
  EXPECT_NEAR(edge_term(a, a, n), 0, 1);
  EXPECT_EQ(edge_term(a, {-a.x, -a.y, -a.z}, n), 0);
}

// The bisector is then what rounding has left of a sum, and may point away from both.
TEST(Arc, NearlyOppositeDirectionsGiveAtMostAHalfTurn) {
  const Vec3 a = {kArcOne, 0, 0}, n = {0, 0, kArcOne};
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      ASSERT_LE(std::abs(std::ldexp(edge_term(a, {-kArcOne + x, y, 0}, n), -kAngleBits)), kPi + 1e-6);
    }
  }
}

}  // namespace
}  // namespace fixrad::host

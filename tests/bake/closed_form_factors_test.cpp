// SPDX-License-Identifier: MIT
// Area-averaged form factors of pairs that nothing hides against their closed forms.
#include "host_sim/bake/closed_form_factors.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/bake/sample.h"
#include "tests/lib/closed_forms.h"
#include "tests/lib/scenes.h"

namespace fixrad::host::testing {
namespace {

constexpr double kBound = 0.001;  // relative, each

// A model ready for the contour formula; one element a face, since none is used.
struct Prepared {
  explicit Prepared(Model made)
      : model(std::move(made)),
        scene(prepare(model)),
        device(make_device_scene(scene, make_uniform(scene, 1, 1))),
        factors(scene, device) {}

  double operator()(std::uint32_t i, std::uint32_t j) { return factors.factor(i, j).value(); }

  Model model;
  PreparedScene scene;
  DeviceScene device;
  ClosedFormFactors factors;
};

void expect_within(double factor, double exact) {
  ::testing::Test::RecordProperty("error_percent", std::to_string(100 * (factor / exact - 1)));
  EXPECT_NEAR(factor / exact, 1.0, kBound) << factor << " instead of " << exact;
}

// A floor from `a` and a ceiling over it from `b`, `z` apart: x and y of the closed form along x and z.
Prepared parallel(const Rectangle& a, const Rectangle& b, double z) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.polygon({{a.x0, 0, a.y0}, {a.x0, 0, a.y1}, {a.x1, 0, a.y1}, {a.x1, 0, a.y0}}, 0);
  builder.polygon({{b.x0, z, b.y0}, {b.x1, z, b.y0}, {b.x1, z, b.y1}, {b.x0, z, b.y1}}, 0);
  return Prepared(builder.model());
}

// A floor and a wall in the plane x = 0 that looks at it.
Prepared perpendicular(const Rectangle& floor, const Rectangle& wall) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  const Rectangle& f = floor;
  const Rectangle& w = wall;
  builder.polygon({{f.x0, 0, f.y0}, {f.x0, 0, f.y1}, {f.x1, 0, f.y1}, {f.x1, 0, f.y0}}, 0);
  builder.polygon({{0, w.x0, w.y0}, {0, w.x1, w.y0}, {0, w.x1, w.y1}, {0, w.x0, w.y1}}, 0);
  return Prepared(builder.model());
}

void expect_both_ways(Prepared pair, double exact, double area_ratio) {
  expect_within(pair(0, 1), exact);
  expect_within(pair(1, 0), exact * area_ratio);
}

double area_of(const Rectangle& r) {
  return (r.x1 - r.x0) * (r.y1 - r.y0);
}

TEST(ClosedFormFactors, OfParallelPlatesAreTheClosedForm) {
  for (const double z : {0.05, 0.2, 1.0, 4.0}) {
    const Rectangle unit = {0, 1, 0, 1};
    expect_both_ways(parallel(unit, unit, z), parallel_form_factor(unit, unit, z), 1);
  }
}

TEST(ClosedFormFactors, OfOffsetParallelPlatesAreTheClosedForm) {
  const Rectangle floor = {0, 2, 0, 1};
  for (const Rectangle& ceiling : {Rectangle{1.5, 3, 0.5, 2}, {3, 4, 2, 3}, {0.75, 1, 0.25, 0.5}}) {
    expect_both_ways(parallel(floor, ceiling, 0.5), parallel_form_factor(floor, ceiling, 0.5),
                     area_of(floor) / area_of(ceiling));
  }
}

TEST(ClosedFormFactors, OfPerpendicularPlatesWithACommonEdgeAreTheClosedForm) {
  for (const double height : {0.25, 1.0, 3.0}) {
    const Rectangle floor = {0, 1, 0, 2}, wall = {0, height, 0, 2};
    expect_both_ways(perpendicular(floor, wall), perpendicular_form_factor(floor, wall), 1 / height);
  }
}

TEST(ClosedFormFactors, OfOffsetPerpendicularPlatesAreTheClosedForm) {
  const Rectangle floor = {0.5, 1.5, 0, 1};
  for (const Rectangle& wall : {Rectangle{0.25, 1, 0, 1}, {0, 1, 1.5, 2.5}, {0, 0.5, 0.5, 2}}) {
    expect_both_ways(perpendicular(floor, wall), perpendicular_form_factor(floor, wall),
                     area_of(floor) / area_of(wall));
  }
}

// Inside a regular tetrahedron every face sees the three others alike; they touch, at 70.5 degrees.
TEST(ClosedFormFactors, OfTheFacesOfATetrahedronAreAThird) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  const glm::dvec3 a(0, 0, 0), b(1, 1, 0), c(1, 0, 1), d(0, 1, 1);
  for (const auto& face : {std::vector{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}}) {
    builder.polygon(face, 0);
  }
  Prepared inside(builder.model());
  for (std::uint32_t i = 0; i < 4; ++i) {
    for (std::uint32_t j = 0; j < 4; ++j) {
      if (i != j) {
        expect_within(inside(i, j), 1.0 / 3);
      }
    }
  }
}

// The corner of a cube cut off: three right triangles and the equilateral one, sqrt(3) times as large, that
// sees them alike. Reciprocity and the sum of a row give the rest; the tilt is 54.7 degrees.
TEST(ClosedFormFactors, OfACornerOfACubeFollowFromItsSymmetry) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  const glm::dvec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  for (const auto& face : {std::vector{o, x, y}, {o, y, z}, {o, z, x}, {x, z, y}}) {
    builder.polygon(face, 0);
  }
  Prepared inside(builder.model());
  for (std::uint32_t i = 0; i < 3; ++i) {
    expect_within(inside(3, i), 1.0 / 3);
    expect_within(inside(i, 3), 1 / std::sqrt(3.0));
    expect_within(inside(i, (i + 1) % 3), (1 - 1 / std::sqrt(3.0)) / 2);
  }
}

TEST(ClosedFormFactors, AreNotGivenWhereAFaceMayStandBetween) {
  Prepared room(room_with_box(Stand::floating, 0.3));
  EXPECT_FALSE(room.factors.factor(2, 3)) << "the box floats between floor and ceiling";
  EXPECT_TRUE(room.factors.factor(6, 7) == 0.0) << "faces of a convex body do not see each other";
}

}  // namespace
}  // namespace fixrad::host::testing

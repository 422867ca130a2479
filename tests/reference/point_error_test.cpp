// SPDX-License-Identifier: MIT
#include "host_sim/reference/point_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace fixrad::host {
namespace {

MeshElement polygon(const std::vector<glm::dvec3>& corners, double reflectance, double emission,
                    std::uint32_t face) {
  MeshElement element;
  element.polygon = corners;
  const glm::dvec3 cross = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  element.normal = glm::normalize(cross);
  element.area = glm::length(cross);
  element.centroid = 0.5 * (corners[0] + corners[2]);
  element.reflectance = glm::dvec3(reflectance);
  element.emission = glm::dvec3(emission);
  element.input_face = face;
  return element;
}

// A floor of 4 x 4 with a lamp over it and a cube without a bottom on a sixteenth of it.
std::vector<MeshElement> room_with_cube() {
  std::vector<MeshElement> room = {polygon({{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}}, 0.5, 0, 0),
                                   polygon({{0, 4, 0}, {4, 4, 0}, {4, 4, 4}, {0, 4, 4}}, 0.5, 1, 1)};
  room.push_back(polygon({{1, 1, 1}, {1, 1, 2}, {2, 1, 2}, {2, 1, 1}}, 0.5, 0, 2));
  room.push_back(polygon({{1, 0, 1}, {1, 0, 2}, {1, 1, 2}, {1, 1, 1}}, 0.5, 0, 3));
  room.push_back(polygon({{2, 0, 2}, {2, 0, 1}, {2, 1, 1}, {2, 1, 2}}, 0.5, 0, 4));
  room.push_back(polygon({{2, 0, 1}, {1, 0, 1}, {1, 1, 1}, {2, 1, 1}}, 0.5, 0, 5));
  room.push_back(polygon({{1, 0, 2}, {2, 0, 2}, {2, 1, 2}, {1, 1, 2}}, 0.5, 0, 6));
  return room;
}

TEST(SurfacePoints, AreEvenlySpreadOverWhatReflectsAndCanBeSeen) {
  const std::vector<SamplePoint> points = surface_points(room_with_cube(), 1000);
  ASSERT_EQ(points.size(), 1000u);
  std::vector<int> count(7);
  for (const SamplePoint& point : points) {
    const glm::dvec3 p = point.surface.position;
    EXPECT_FALSE(point.input_face == 0 && p.x > 1 && p.x < 2 && p.z > 1 && p.z < 2) << "under the cube";
    ++count[point.input_face];
  }
  EXPECT_EQ(count[1], 0) << "the lamp";
  EXPECT_NEAR(count[0], 750, 15);  // 15 of 20 square metres, and a square metre for each face of the cube
  for (const int face : {2, 3, 4, 5, 6}) {
    EXPECT_NEAR(count[static_cast<std::size_t>(face)], 50, 10);
  }
}

TEST(SurfacePoints, TakeEveryFaceWhereAllEmitAsInAFurnace) {
  const std::vector<SamplePoint> points =
      surface_points({polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, 0.5, 1, 0)}, 10);
  EXPECT_EQ(points.size(), 10u);
}

TEST(SurfacePoints, OfAThousandTheFirstAreThoseOfAHundred) {
  const auto few = surface_points(room_with_cube(), 100), many = surface_points(room_with_cube(), 1000);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].surface.position, many[i].surface.position);
  }
}

SamplePoint point_at(glm::dvec3 position, glm::dvec3 reflectance = glm::dvec3(0.5)) {
  return {{position, {0, 1, 0}}, reflectance, glm::dvec3(0.0), 0};
}

TEST(PointErrorMean, IsTheSumOfDifferencesOverTheSumOfLight) {
  const std::vector<SamplePoint> points = {point_at({0, 0, 0}), point_at({1, 0, 0})};
  const Traced truth = {{glm::dvec3(1.0), glm::dvec3(3.0)}, {glm::dvec3(0.1), glm::dvec3(0.1)}};
  const PointError error = compare_points(points, {glm::dvec3(1.1), glm::dvec3(2.7)}, truth);
  EXPECT_NEAR(error.mean, (0.1 + 0.3) / 4.0, 1e-12);
  EXPECT_NEAR(error.percentile95, 0.1, 1e-12);
  EXPECT_NEAR(truth_error(points, truth), 0.2 / 4.0, 1e-12);
}

TEST(PointErrorMean, LeavesOutChannelsThatAreNotReflected) {
  const std::vector<SamplePoint> points = {point_at({0, 0, 0}, {0.5, 0.0, 0.5})};
  const Traced truth = {{glm::dvec3(1.0)}, {glm::dvec3(0.0)}};
  EXPECT_EQ(compare_points(points, {glm::dvec3(1.0, 77.0, 1.0)}, truth).mean, 0.0);
  EXPECT_EQ(irradiance_of(points[0], glm::dvec3(0.5)), glm::dvec3(1.0, 0.0, 1.0));
}

TEST(Interpolation, IsExactForALinearFieldAndTakesTheTriangleThatFacesTheSameWay) {
  const std::vector<glm::dvec3> positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0},
                                             {0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  const std::vector<std::array<std::uint32_t, 3>> triangles = {
      {0, 1, 2}, {0, 2, 3}, {4, 5, 6}};  // last: down
  std::vector<glm::dvec3> values;
  for (std::size_t v = 0; v < 4; ++v) {
    values.emplace_back(2 + 3 * positions[v].x - positions[v].z);
  }
  values.insert(values.end(), 3, glm::dvec3(99.0));
  for (const glm::dvec3 p : {glm::dvec3(0.2, 0, 0.7), glm::dvec3(0.9, 0, 0.1), glm::dvec3(0.5, 0, 0.5)}) {
    const glm::dvec3 found = interpolate(positions, triangles, values, {point_at(p)}).front();
    EXPECT_NEAR(found.x, 2 + 3 * p.x - p.z, 1e-12);
  }
}

}  // namespace
}  // namespace fixrad::host

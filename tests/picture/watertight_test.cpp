// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

#include "host_sim/report/conforming_mesh.h"
#include "tests/picture/device_mesh.h"

namespace fixrad::host::testing {
namespace {

// The inside of the unit cube; every wall has a grid of its own, so their meshes do not meet at the edges.
// The cube is turned, so that rounding moves every vertex.
BakedMesh closed_room() {
  BakedMesh mesh;
  const glm::dvec3 x(0.8, 0.36, 0.48), y(-0.6, 0.48, 0.64), z(0, -0.8, 0.6);
  const auto wall = [&](const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v, int cells) {
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const double step = 1.0 / cells;
        add_quad(mesh, origin + step * (static_cast<double>(i) * u + static_cast<double>(j) * v), step * u,
                 step * v, {1, 1, 1});
      }
    }
  };
  wall({0, 0, 0}, x, y, 2);
  wall(z, y, x, 3);
  wall({0, 0, 0}, z, x, 5);
  wall(y, x, z, 7);
  wall({0, 0, 0}, y, z, 3);
  wall(x, z, y, 4);
  return mesh;
}

TEST(ConformingMesh, OfAClosedRoomHasEverySideInTwoTrianglesInOppositeDirections) {
  const ConformingMesh mesh = make_conforming(closed_room(), units_over({-0.6, -0.8, 0}, 1.8).grid);
  std::map<std::array<int, 6>, int> times;
  const auto count = [&](const glm::ivec3& a, const glm::ivec3& b) {
    ++times[{a.x, a.y, a.z, b.x, b.y, b.z}];
  };
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      count(mesh.positions[triangle[k]], mesh.positions[triangle[(k + 1) % 3]]);
    }
  }
  for (const auto& [side, number] : times) {
    ASSERT_EQ(number, 1);
    ASSERT_EQ((times.count({side[3], side[4], side[5], side[0], side[1], side[2]})), 1u);
  }
}

TEST(ConformingMesh, KeepsTheMeshsVerticesAndInsertsSomeBetweenThem) {
  const BakedMesh room = closed_room();
  const ConformingMesh mesh = make_conforming(room, units_over({-0.6, -0.8, 0}, 1.8).grid);
  EXPECT_EQ(mesh.positions.size(), room.positions.size() + mesh.inserted.size());
  EXPECT_GT(mesh.inserted.size(), 20u);
  for (std::size_t i = 0; i < mesh.inserted.size(); ++i) {
    const InsertedPoint& point = mesh.inserted[i];
    const glm::dvec3 a(mesh.positions[point.from]), b(mesh.positions[point.to]);
    EXPECT_LT(glm::distance(glm::dvec3(mesh.positions[room.positions.size() + i]), a + point.part * (b - a)),
              1.8)
        << "three points rounded by up to sqrt(3)/2, in one direction at worst two of them";
  }
}

TEST(DeviceRenderer, ShowsNoBackgroundInsideAClosedRoom) {
  const BakedMesh room = closed_room();
  const DeviceUnits units = units_over({-0.6, -0.8, 0}, 1.8);
  const glm::dvec3 middle(0.1, 0.02, 0.86);
  std::mt19937 random(5);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  for (int view = 0; view < 40; ++view) {
    const glm::dvec3 eye = middle + 0.5 * glm::dvec3(number(), number(), number());
    const glm::dvec3 target = middle + 3.0 * glm::dvec3(number(), number(), number());
    const Image image = device_picture(room, units, {160, 120, Camera{eye, target, 100.0}}, 120);
    for (std::size_t i = 1; i < image.rgb.size(); ++i) {
      ASSERT_EQ(image.rgb[i], image.rgb[0]) << "view " << view << ", pixel " << i / 3;
    }
    EXPECT_GT(image.rgb[0], 100);
  }
}

}  // namespace
}  // namespace fixrad::host::testing

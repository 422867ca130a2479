// SPDX-License-Identifier: MIT
#include "host_sim/meshing/direct_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/reference/contour.h"
#include "host_sim/reference/visibility.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

std::vector<glm::dvec3> corners_of(const PreparedScene& scene, std::uint32_t face) {
  std::vector<glm::dvec3> corners;
  for (const std::uint32_t v : scene.faces[face].corners) {
    corners.emplace_back(scene.vertices.positions[v]);
  }
  return corners;
}

TEST(DirectLight, OfAnEmptyRoomIsLambertsFormula) {
  const Model model = cube(0.5, {0, 0, 0, 3, 0, 0});
  const PreparedScene scene = prepare(model);
  const DirectLight light(scene);
  for (const std::uint32_t face : {0u, 2u, 5u}) {
    for (const glm::dvec2 st : {glm::dvec2(0.5), glm::dvec2(0.1, 0.7), glm::dvec2(0.99, 0.02)}) {
      const glm::dvec3 p = scene.frames[face].to_grid(st);
      const double expected = 3 * point_to_polygon(p, scene.faces[face].normal, corners_of(scene, 3));
      EXPECT_NEAR(light.irradiance(face, p), expected, 1e-12);
      EXPECT_NEAR(light.unhidden(face, p), expected, 1e-12);
    }
  }
}

// The sum over many rays is the definition; a lamp of 1 m^2 is 40 x 40 points.
TEST(DirectLight, BehindBoxesIsTheSumOverRays) {
  constexpr int kPoints = 40;
  constexpr double kGrazing = 1e-4;  // W/m^2, where the lamp is seen edge-on and cells are too large for rays
  int half_hidden = 0;
  for (const std::uint32_t seed : {1u, 4u, 5u, 9u}) {
    const Model model = random_open_room(seed);
    const PreparedScene scene = prepare(model);
    const DirectLight light(scene);
    std::vector<glm::dvec3> positions;
    std::vector<std::uint32_t> triangles;
    std::uint32_t lamp = 0;
    for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
      const auto first = static_cast<std::uint32_t>(positions.size());
      const std::vector<glm::dvec3> corners = corners_of(scene, f);
      positions.insert(positions.end(), corners.begin(), corners.end());
      for (std::uint32_t k = 2; k < corners.size(); ++k) {
        triangles.insert(triangles.end(), {first, first + k - 1, first + k});
      }
      if (scene.model->materials[scene.faces[f].material].emission.x > 0) {
        lamp = f;
      }
    }
    const RayScene rays(positions, triangles);
    const FaceFrame& source = scene.frames[lamp];
    const glm::dvec3 emission = scene.model->materials[scene.faces[lamp].material].emission;
    const double part = (emission.x + emission.y + emission.z) / 3 * source.unit_area() / (kPoints * kPoints);
    for (std::uint32_t face = 0; face < scene.faces.size(); ++face) {
      const glm::dvec3 normal = scene.faces[face].normal;
      for (int i = 0; i < 8; ++i) {
        const glm::dvec3 p = scene.frames[face].to_grid(
            {std::fmod(0.5 + i * 0.7548777, 1.0), std::fmod(0.5 + i * 0.5698403, 1.0)});
        double sum = 0;
        for (int k = 0; k < kPoints * kPoints; ++k) {
          const glm::dvec3 q = source.to_grid({(k % kPoints + 0.5) / kPoints, (k / kPoints + 0.5) / kPoints});
          const glm::dvec3 way = q - p;
          const double squared = glm::dot(way, way);
          const double cosines =
              std::max(0.0, glm::dot(way, normal)) * -glm::dot(way, source.normal) / squared;
          if (cosines > 0 && rays.visible(p, normal, q, source.normal)) {
            sum += part * cosines / (3.14159265358979 * squared);
          }
        }
        const double unhidden = light.unhidden(face, p);
        half_hidden += sum > 0.1 * unhidden && sum < 0.9 * unhidden ? 1 : 0;
        EXPECT_NEAR(light.irradiance(face, p), sum, 0.02 * unhidden + kGrazing)
            << "seed " << seed << " face " << face;
      }
    }
  }
  EXPECT_GT(half_hidden, 10);
}

}  // namespace
}  // namespace fixrad::host

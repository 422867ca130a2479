// SPDX-License-Identifier: MIT
#include "host_sim/meshing/quantise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "lib/scene/scene.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

Model scaled(Model model, double factor, glm::dvec3 shift) {
  for (glm::dvec3& p : model.positions) {
    p = p * factor + shift;
  }
  return model;
}

TEST(Quantise, MovesAVertexByAtMostHalfTheDiagonalOfAGridCell) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Model model = random_closed_room(seed);
    const QuantisedVertices vertices = quantise(model);
    const double bound = std::sqrt(3.0) / 2 / vertices.grid.scale;
    double largest = 0;
    for (std::size_t v = 0; v < model.positions.size(); ++v) {
      const glm::dvec3 on_grid(vertices.positions[vertices.index_of[v]]);
      largest = std::max(largest, glm::distance(vertices.grid.to_scene(on_grid), model.positions[v]));
    }
    EXPECT_LE(largest, bound * (1 + 1e-9));
    EXPECT_NEAR(vertices.largest_error, largest, 1e-9);
  }
}

TEST(Quantise, UsesTheGridInAnyUnitAndAnywhere) {
  for (const double factor : {1e-6, 0.01, 1.0, 1000.0, 1e9}) {
    const QuantisedVertices vertices =
        quantise(scaled(cornell(), factor, glm::dvec3(-3.0 * factor, 0, 7 * factor)));
    int low = kGridMax, high = 0;
    for (const glm::ivec3& p : vertices.positions) {
      low = std::min({low, p.x, p.y, p.z});
      high = std::max({high, p.x, p.y, p.z});
    }
    EXPECT_GE(low, 1) << "room for lifted eyes";
    EXPECT_LE(high, kGridMax - 1);
    EXPECT_GT(high - low, kGridMax * 99 / 100);
  }
}

TEST(Quantise, WeldsVerticesThatMeetOnTheGrid) {
  Model model = cube(0.5, {1, 0, 0, 0, 0, 0});
  const std::size_t corners = quantise(model).positions.size();
  model.positions.push_back(model.positions[0] + glm::dvec3(1e-7));
  model.faces[1].corners[0] = model.faces[1].corners[0] == 0 ? 8 : model.faces[1].corners[0];
  EXPECT_EQ(quantise(model).positions.size(), corners);
  EXPECT_EQ(corners, 8u);
}

TEST(Quantise, IgnoresVerticesThatNoFaceUses) {
  Model model = cube(0.5, {1, 0, 0, 0, 0, 0});
  const double scale = quantise(model).grid.scale;
  model.positions.emplace_back(1e6, 0, 0);
  EXPECT_EQ(quantise(model).grid.scale, scale);
}

TEST(Quantise, RefusesASceneWithoutExtent) {
  Model model = cube(0.5, {1, 0, 0, 0, 0, 0});
  for (glm::dvec3& p : model.positions) {
    p = glm::dvec3(3.0);
  }
  EXPECT_THROW(quantise(model), InputError);
  EXPECT_THROW(quantise(Model()), InputError);
}

TEST(Quantise, RefusesASceneWhoseScaleHasNoSquare) {
  Model model = cube(0.5, {1, 0, 0, 0, 0, 0});
  for (glm::dvec3& p : model.positions) {
    p *= 1e-200;
  }
  EXPECT_THROW(quantise(model), InputError);
}

TEST(Quantise, NamesTheFaceThatBringsTooManyVertices) {
  Model model = cube(0.5, {1, 0, 0, 0, 0, 0});
  for (std::uint32_t i = 0; i < 65535; ++i) {
    model.positions.emplace_back((i % 256) / 256.0, (i / 256) / 256.0, 0.5);
    Face face = {{0, 1, static_cast<std::uint32_t>(model.positions.size() - 1)}};
    face.line = static_cast<int>(i);
    model.faces.push_back(face);
  }
  try {
    quantise(model);
    ADD_FAILURE() << "the core numbers vertices in 16 bits";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "test:65527: error: this face brings the vertices to more than 65535; simplify the scene");
  }
}

}  // namespace
}  // namespace fixrad::host

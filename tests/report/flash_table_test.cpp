// SPDX-License-Identifier: MIT
// The table that make_samples wrote at build time, included as firmware would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "hand_made.hpp"
#include "host_sim/report/tone.h"
#include "host_sim/report/writers.h"
#include "tests/report/sample_mesh.h"
#include "tests/report/scratch_folder.h"

namespace fixrad::host {
namespace {

TEST(FlashTable, HasTheMeshsVerticesAndTriangles) {
  const BakedMesh mesh = testing::open_room();
  ASSERT_EQ(open_room::vertex_count, mesh.positions.size());
  ASSERT_EQ(open_room::triangle_count, mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(open_room::triangles[i][k], mesh.triangles[i][k]);
    }
  }
}

TEST(FlashTable, KeepsPositionsWithinHalfAStep) {
  const BakedMesh mesh = testing::open_room();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double position = double{open_room::position_offset[k]} +
                              open_room::positions[i][k] * double{open_room::position_scale};
      EXPECT_NEAR(position, mesh.positions[i][k], 0.5 * double{open_room::position_scale});
    }
  }
}

TEST(FlashTable, HasTheDisplayColoursOfTheMesh) {
  const BakedMesh mesh = testing::open_room();
  const double scale = exposure_scale(mesh, {});
  EXPECT_EQ(open_room::exposure, static_cast<float>(scale));
  EXPECT_EQ(open_room::exposure_ev, 0.0f);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 linear = tone(mesh.radiosity[i] * scale);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(open_room::colors[i][k], 255.0 * srgb_from_linear(linear[k]), 0.5);
    }
  }
}

TEST(FlashTable, KeepsRadiosityWithinHalfAnRgbeStep) {
  const BakedMesh mesh = testing::open_room();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double step = std::ldexp(1.0, open_room::radiosity[i][3] - open_room::radiosity_bias);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(open_room::radiosity[i][k] * step, mesh.radiosity[i][k], 0.5 * step);
    }
  }
}

TEST(FlashTable, TakesWideIndicesOnlyWhereItMust) {
  EXPECT_EQ(sizeof open_room::triangles[0][0], 2u);
  BakedMesh mesh = testing::square({1, 1, 1});
  mesh.positions.resize(65537, {0, 0, 0});
  mesh.normals.resize(65537, {0, 0, 1});
  mesh.radiosity.resize(65537, {1, 1, 1});
  mesh.triangles.push_back({0, 1, 65536});
  const testing::ScratchFolder folder;
  write_hpp(folder / "wide.hpp", mesh, {});
  const std::string text = testing::contents(folder / "wide.hpp");
  EXPECT_THAT(text, ::testing::HasSubstr("uint32_t triangles[triangle_count][3]"));
  EXPECT_THAT(text, ::testing::HasSubstr("{0, 1, 65536}"));
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cstring>
#include <string>
#include <vector>

#include "host_sim/report/tone.h"
#include "host_sim/report/writers.h"
#include "tests/report/sample_mesh.h"
#include "tests/report/scratch_folder.h"

namespace fixrad::host {
namespace {

tinygltf::Model written(const BakedMesh& mesh, const Display& display) {
  const testing::ScratchFolder folder;
  write_glb(folder / "a.glb", mesh, display);
  tinygltf::Model gltf;
  std::string error;
  std::string warning;
  EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&gltf, &error, &warning, (folder / "a.glb").string()))
      << error;
  EXPECT_EQ(error + warning, "");
  return gltf;
}

const tinygltf::Primitive& primitive(const tinygltf::Model& gltf) {
  return gltf.meshes.at(0).primitives.at(0);
}

template <typename Number>
std::vector<Number> values(const tinygltf::Model& gltf, int index) {
  const tinygltf::Accessor& accessor = gltf.accessors.at(static_cast<std::size_t>(index));
  const auto& view = gltf.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  std::vector<Number> result(view.byteLength / sizeof(Number));
  std::memcpy(result.data(), gltf.buffers.at(0).data.data() + view.byteOffset, view.byteLength);
  return result;
}

std::vector<float> attribute(const tinygltf::Model& gltf, const char* name) {
  return values<float>(gltf, primitive(gltf).attributes.at(name));
}

TEST(Glb, HoldsPositionsNormalsAndTriangles) {
  const BakedMesh mesh = testing::open_room();
  const tinygltf::Model gltf = written(mesh, {});
  const std::vector<float> positions = attribute(gltf, "POSITION");
  const std::vector<float> normals = attribute(gltf, "NORMAL");
  ASSERT_EQ(positions.size(), 3 * mesh.positions.size());
  ASSERT_EQ(normals.size(), 3 * mesh.positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const int k = static_cast<int>(i % 3);
    EXPECT_EQ(positions[i], static_cast<float>(mesh.positions[i / 3][k]));
    EXPECT_EQ(normals[i], static_cast<float>(mesh.normals[i / 3][k]));
  }
  const auto indices = values<std::uint32_t>(gltf, primitive(gltf).indices);
  ASSERT_EQ(indices.size(), 3 * mesh.triangles.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    EXPECT_EQ(indices[i], mesh.triangles[i / 3][i % 3]);
  }
}

TEST(Glb, HoldsToneMappedLinearColours) {
  const BakedMesh mesh = testing::open_room();
  Display display;
  display.exposure_ev = 1.5;
  const std::vector<float> colours = attribute(written(mesh, display), "COLOR_0");
  const double scale = exposure_scale(mesh, display);
  ASSERT_EQ(colours.size(), 3 * mesh.positions.size());
  for (std::size_t i = 0; i < colours.size(); ++i) {
    EXPECT_EQ(colours[i], static_cast<float>(tone(mesh.radiosity[i / 3] * scale)[static_cast<int>(i % 3)]));
  }
}

TEST(Glb, BoundsItsPositions) {
  const tinygltf::Model gltf = written(testing::open_room(), {});
  const auto& accessor =
      gltf.accessors.at(static_cast<std::size_t>(primitive(gltf).attributes.at("POSITION")));
  EXPECT_THAT(accessor.minValues, ::testing::ElementsAre(0.0, 0.0, 0.0));
  EXPECT_THAT(accessor.maxValues, ::testing::ElementsAre(1.0, 1.0, 1.0));
}

TEST(Glb, IsUnlitSoThatViewersDoNotLightItAgain) {
  const tinygltf::Model gltf = written(testing::open_room(), {});
  EXPECT_THAT(gltf.extensionsUsed, ::testing::ElementsAre("KHR_materials_unlit"));
  EXPECT_EQ(gltf.materials.at(0).extensions.count("KHR_materials_unlit"), 1u);
  EXPECT_FALSE(gltf.materials.at(0).doubleSided);
}

TEST(Glb, TurnsASceneWithZUpSoThatYIsUp) {
  BakedMesh mesh = testing::square({1, 1, 1});  // lit side +z, which is up
  mesh.positions[2] = {1, 2, 3};
  Display display;
  display.z_up = true;
  const tinygltf::Model gltf = written(mesh, display);
  const std::vector<float> positions = attribute(gltf, "POSITION");
  EXPECT_THAT(std::vector<float>(positions.begin() + 6, positions.begin() + 9),
              ::testing::ElementsAre(1.0f, 3.0f, -2.0f));
  const std::vector<float> normals = attribute(gltf, "NORMAL");
  EXPECT_THAT(std::vector<float>(normals.begin(), normals.begin() + 3),
              ::testing::ElementsAre(0.0f, 1.0f, 0.0f));
}

}  // namespace
}  // namespace fixrad::host

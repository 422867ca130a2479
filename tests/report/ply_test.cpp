// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/report/tone.h"
#include "host_sim/report/writers.h"
#include "tests/report/sample_mesh.h"
#include "tests/report/scratch_folder.h"

namespace fixrad::host {
namespace {

struct Ply {
  std::vector<std::string> properties;
  std::vector<std::string> comments;
  std::vector<std::vector<float>> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;
};

Ply parse(const std::string& text) {
  Ply ply;
  std::istringstream stream(text);
  std::string line;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  while (std::getline(stream, line) && line != "end_header") {
    std::istringstream words(line);
    std::string first;
    std::string second;
    words >> first >> second;
    if (first == "comment") {
      ply.comments.push_back(line);
    } else if (first == "element") {
      words >> (second == "vertex" ? vertices : faces);
    } else if (first == "property") {
      ply.properties.push_back(line.substr(9));
    }
  }
  ply.vertices.assign(vertices, std::vector<float>(ply.properties.size() - 1));
  for (auto& vertex : ply.vertices) {
    for (float& value : vertex) {
      std::string word;
      stream >> word;
      value = std::stof(word);
    }
  }
  ply.faces.resize(faces);
  for (auto& face : ply.faces) {
    stream >> face[0] >> face[1] >> face[2] >> face[3];
  }
  EXPECT_TRUE(static_cast<bool>(stream));
  EXPECT_FALSE(static_cast<bool>(stream >> line)) << "something follows the last face: " << line;
  return ply;
}

Ply written(const BakedMesh& mesh, const Display& display) {
  const testing::ScratchFolder folder;
  write_ply(folder / "a.ply", mesh, display);
  return parse(testing::contents(folder / "a.ply"));
}

TEST(Ply, NamesItsProperties) {
  const Ply ply = written(testing::open_room(), {});
  EXPECT_THAT(ply.properties,
              ::testing::ElementsAre("float x", "float y", "float z", "float nx", "float ny", "float nz",
                                     "uchar red", "uchar green", "uchar blue", "float B_r", "float B_g",
                                     "float B_b", "list uchar int vertex_indices"));
}

TEST(Ply, ReadsBackAsTheSameFloats) {
  BakedMesh mesh = testing::open_room();
  mesh.radiosity[0] = {1.0 / 3.0, 1e-30, 12345678.9};
  mesh.positions[1] = {0.1, -2.0 / 3.0, 1e10};
  const Ply ply = written(mesh, {});
  ASSERT_EQ(ply.vertices.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(k);
      EXPECT_EQ(ply.vertices[i][at], static_cast<float>(mesh.positions[i][k]));
      EXPECT_EQ(ply.vertices[i][3 + at], static_cast<float>(mesh.normals[i][k]));
      EXPECT_EQ(ply.vertices[i][9 + at], static_cast<float>(mesh.radiosity[i][k]));
    }
  }
}

TEST(Ply, ShowsTheDisplayColourOfEachVertex) {
  const BakedMesh mesh = testing::open_room();
  Display display;
  display.exposure_ev = 0.5;
  const Ply ply = written(mesh, display);
  const double scale = exposure_scale(mesh, display);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Srgb8 colour = display_colour(mesh.radiosity[i], scale);
    EXPECT_THAT(std::vector<int>(ply.vertices[i].begin() + 6, ply.vertices[i].begin() + 9),
                ::testing::ElementsAre(colour[0], colour[1], colour[2]));
  }
}

TEST(Ply, ListsTheTriangles) {
  const BakedMesh mesh = testing::square({1, 1, 1});
  EXPECT_THAT(written(mesh, {}).faces, ::testing::ElementsAre(std::array<std::uint32_t, 4>{3, 0, 1, 2},
                                                              std::array<std::uint32_t, 4>{3, 0, 2, 3}));
}

TEST(Ply, SaysUnitAndExposureInComments) {
  BakedMesh mesh = testing::square({0.6, 0.6, 0.6});
  mesh.name = "two\nlines";
  Display display;
  display.exposure_ev = 1.0;
  const Ply ply = written(mesh, display);
  EXPECT_THAT(ply.comments, ::testing::Contains(::testing::HasSubstr("W/m^2")));
  EXPECT_THAT(ply.comments, ::testing::Contains(::testing::HasSubstr("EV 1")));
  EXPECT_THAT(ply.comments, ::testing::Contains(::testing::HasSubstr("two_lines")));
}

}  // namespace
}  // namespace fixrad::host

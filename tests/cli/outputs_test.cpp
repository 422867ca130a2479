// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// The faces of an OBJ whose `f` lines hold plain indices: their areas by Newell's formula.
std::vector<double> areas_in(const std::string& obj) {
  std::vector<std::array<double, 3>> vertices;
  std::vector<double> areas;
  for (const std::string& line : lines_of(contents(obj))) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v") {
      auto& v = vertices.emplace_back();
      words >> v[0] >> v[1] >> v[2];
    } else if (keyword == "f") {
      std::vector<std::size_t> corners;
      for (std::size_t i = 0; words >> i;) {
        corners.push_back(i - 1);
      }
      std::array<double, 3> normal = {};
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& p = vertices[corners[i]];
        const auto& q = vertices[corners[(i + 1) % corners.size()]];
        for (std::size_t a = 0; a < 3; ++a) {
          normal[a] += (p[(a + 1) % 3] * q[(a + 2) % 3] - p[(a + 2) % 3] * q[(a + 1) % 3]) / 2;
        }
      }
      areas.push_back(std::hypot(normal[0], normal[1], normal[2]));
    }
  }
  return areas;
}

TEST(Outputs, WritesEverySuffixOfOneRun) {
  const ScratchFolder folder;
  std::vector<std::string> arguments = {"bake", sample_scene("cornell"), "--profile", "tiny"};
  for (const char* suffix : {"hpp", "glb", "ply", "png", "csv", "json"}) {
    arguments.insert(arguments.end(), {"-o", folder / ("room." + std::string(suffix))});
  }
  const Outcome run = run_tool(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(names_in(folder / ""), ::testing::ElementsAre("room.csv", "room.glb", "room.hpp", "room.json",
                                                            "room.ply", "room.png"));
  EXPECT_THAT(contents(folder / "room.glb"), StartsWith("glTF"));
  EXPECT_THAT(contents(folder / "room.png"), StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_THAT(contents(folder / "room.hpp"), HasSubstr("constexpr"));
  EXPECT_TRUE(nlohmann::json::accept(contents(folder / "room.json")));
  // One line an element, and the header.
  const auto json = nlohmann::json::parse(contents(folder / "room.json"));
  EXPECT_EQ(lines_of(contents(folder / "room.csv")).size(), json["elements"].get<std::size_t>() + 1);
}

TEST(Outputs, PlyCarriesLinearRadiosityBesideColours) {
  const ScratchFolder folder;
  const std::string file = folder / "room.ply";
  EXPECT_EQ(run_tool({"bake", sample_scene("cornell"), "--profile", "tiny", "-o", file}).exit_code, 0);
  const std::string text = contents(file);
  EXPECT_THAT(text, StartsWith("ply\nformat ascii 1.0\n"));
  for (const char* name : {"float B_r", "float B_g", "float B_b", "uchar red", "uchar green", "uchar blue"}) {
    EXPECT_THAT(text.substr(0, text.find("end_header")), HasSubstr("property " + std::string(name) + "\n"));
  }
}

TEST(Outputs, FacesCsvHasTheInputsFacesInFileOrderWithTheirAreas) {
  const std::vector<double> areas = areas_in(sample_scene("cornell"));
  const std::vector<FaceRow> rows = baked_faces(sample_scene("cornell"), {"--profile", "small"});
  ASSERT_EQ(rows.size(), areas.size());
  for (std::size_t f = 0; f < rows.size(); ++f) {
    EXPECT_EQ(rows[f].face, static_cast<int>(f));
    EXPECT_NEAR(rows[f].area, areas[f], 1e-6 * areas[f]);
    for (const double b : rows[f].b) {
      EXPECT_TRUE(std::isfinite(b) && b >= 0) << "face " << f;
    }
  }
  EXPECT_EQ(rows[0].material, "white");
  EXPECT_EQ(rows[7].material, "green");
  EXPECT_EQ(rows[8].material, "red");
  // The lamp reflects nothing: its radiosity is its Ke.
  EXPECT_EQ(rows[1].material, "light");
  EXPECT_NEAR(rows[1].b[0], 53.4070751, 0.01);
  EXPECT_NEAR(rows[1].b[2], 12.5663706, 0.01);
}

TEST(Outputs, FacesCsvKeepsFacesThatMeshingCutsOrJoins) {
  std::size_t faces = 0;
  for (const std::string& line : lines_of(contents(sample_scene("furnished_room")))) {
    faces += line.rfind("f ", 0) == 0 ? 1 : 0;
  }
  const std::vector<FaceRow> rows = baked_faces(
      sample_scene("furnished_room"), {"--profile", "large", "--elements", "500", "--unshot", "0.2"});
  EXPECT_EQ(rows.size(), faces);
  for (const FaceRow& row : rows) {
    EXPECT_GT(row.area, 0);
    EXPECT_TRUE(std::isfinite(row.b[0] + row.b[1] + row.b[2])) << "face " << row.face;
  }
}

TEST(Outputs, FacesCsvGivesThreeChannelsForAGreyScene) {
  for (const FaceRow& row : baked_faces(sample_scene("closed_box"), {"--profile", "small"})) {
    // The furnace: B = E / (1 - rho) = 2 W/m^2 on every face.
    EXPECT_NEAR(row.b[0], 2, 0.01);
    EXPECT_EQ(row.b[0], row.b[1]);
    EXPECT_EQ(row.b[0], row.b[2]);
    EXPECT_NEAR(row.area, 1, 1e-6);
  }
}

TEST(Outputs, MissingFolderIsRefusedAndLeavesNoHalfFiles) {
  const ScratchFolder folder;
  const std::string bad = folder / "missing/room.json";
  const Outcome run =
      run_tool({"bake", sample_scene("closed_box"), "--profile", "tiny", "--quiet", "-o", bad});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  EXPECT_THAT(run.err, StartsWith(bad + ": error: "));
  EXPECT_TRUE(names_in(folder / "").empty());
}

TEST(Outputs, AFolderIsNoOutputFile) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "room.json");
  const Outcome run = run_tool(
      {"bake", sample_scene("closed_box"), "--profile", "tiny", "--quiet", "-o", folder / "room.json"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  EXPECT_THAT(names_in(folder / ""), ::testing::ElementsAre("room.json"));
  EXPECT_TRUE(names_in(folder / "room.json").empty());
}

TEST(Outputs, OneBadFileStopsTheRunBeforeAnyIsWritten) {
  const ScratchFolder folder;
  const Outcome run = run_tool({"bake", sample_scene("closed_box"), "--profile", "tiny", "-o",
                                folder / "room.ply", "-o", folder / "missing/room.json"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(names_in(folder / "").empty());
}

TEST(Display, IsGatheredWhereAFileShowsVerticesAndSaysSo) {
  const ScratchFolder folder;
  const std::string scene = sample_scene("portico"), json = folder / "a.json";
  const Outcome run = run_tool({"bake", scene, "--profile", "small", "-o", folder / "a.ply", "-o", json});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("vertices, each gathered, in "), std::string::npos) << run.err;
  const auto shown = nlohmann::json::parse(contents(json));
  EXPECT_EQ(shown["display"], "gather");
  EXPECT_GT(shown["display_seconds"].get<double>(), 0.0);
  const auto mean = baked_json(scene, {"--profile", "small", "--display", "mean"});
  EXPECT_EQ(mean["display"], "mean");
  EXPECT_EQ(mean["display_digest"], mean["digest"]);
  EXPECT_EQ(mean["digest"], shown["digest"]) << "the display changes no solution";
  EXPECT_LT(mean["vertices"].get<int>(), shown["vertices"].get<int>());
  EXPECT_EQ(baked_json(scene, {"--profile", "small"})["display"], "mean") << "nothing shows vertices";
  EXPECT_EQ(baked_json(scene, {"--profile", "small", "--display", "gather"})["display_digest"],
            shown["display_digest"]);
}

}  // namespace
}  // namespace fixrad::host::testing

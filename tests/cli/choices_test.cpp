// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/cli/scene_text.h"
#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;

TEST(Choices, DigestIsTheSameInEveryRunLoudOrQuiet) {
  const ScratchFolder folder;
  const std::string scene = sample_scene("cornell"), file = folder / "baked.json";
  const std::string digest = baked_json(scene, {"--profile", "small"})["digest"];
  EXPECT_EQ(baked_json(scene, {"--profile", "small"})["digest"], digest);
  EXPECT_EQ(baked_json(scene, {"--profile", "small", "--quiet"})["digest"], digest);
  ASSERT_EQ(run_tool({"--quiet", "bake", scene, "--profile", "small", "-o", file}).exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(contents(file))["digest"], digest);
}

TEST(Choices, EnginesAgreeOnTheFurnace) {
  for (const char* engine : {"rows", "pixels"}) {
    for (const FaceRow& row :
         baked_faces(sample_scene("closed_box"), {"--profile", "small", "--engine", engine})) {
      EXPECT_NEAR(row.b[0], 2.0, 0.01) << engine << ", face " << row.face;
    }
  }
}

TEST(Choices, GatheringAgreesWithTheFurnace) {
  for (const FaceRow& row : baked_faces(
           sample_scene("closed_box"), {"--profile", "large", "--solver", "gathering", "--elements", "96"})) {
    EXPECT_NEAR(row.b[0], 2.0, 0.01) << "face " << row.face;
  }
}

TEST(Choices, MaxReflectanceClampsWhatIsRefusedOtherwise) {
  const ScratchFolder folder;
  SceneText text;
  text.room("glowing", {0, 0, 0}, {1, 1, 1});
  const std::string scene = write_scene(folder, text.text());
  const Outcome refused = run_tool({"bake", scene, "--profile", "small"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("--max-reflectance"));
  // The furnace again: E = 1 W/m^2, rho clamped to 0.75, B = 1 / (1 - 0.75).
  for (const FaceRow& row : baked_faces(scene, {"--profile", "small", "--max-reflectance", "0.75"})) {
    EXPECT_NEAR(row.b[0], 4.0, 0.02) << "face " << row.face;
  }
}

TEST(Choices, ResolutionAndStopFractionAreTaken) {
  const auto json = baked_json(sample_scene("closed_box"),
                               {"--profile", "small", "--resolution", "64", "--unshot", "0.01"});
  EXPECT_EQ(json["resolution"], 64);
  EXPECT_LE(json["unshot_fraction"].get<double>(), 0.01);
  EXPECT_GT(json["unshot_fraction"].get<double>(), 0.0);
}

TEST(Choices, AmbientEstimateStaysOutOfTheLedger) {
  const std::vector<std::string> coarse = {"--profile", "small", "--unshot", "0.2"};
  std::vector<std::string> ambient = coarse;
  ambient.push_back("--ambient");
  const auto without = baked_json(sample_scene("closed_box"), coarse);
  EXPECT_EQ(baked_json(sample_scene("closed_box"), ambient)["ledger"], without["ledger"]);
  const double dim = baked_faces(sample_scene("closed_box"), coarse).at(0).b[0];
  const double bright = baked_faces(sample_scene("closed_box"), ambient).at(0).b[0];
  EXPECT_GT(bright, dim);
  EXPECT_NEAR(bright, 2.0, 0.1);
}

}  // namespace
}  // namespace fixrad::host::testing

// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "tests/cli/scene_text.h"
#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The Cornell box with every face turned round: what a tool writes whose normals point outward.
std::string inside_out_cornell(const ScratchFolder& folder) {
  std::string text;
  for (const std::string& line : lines_of(contents(sample_scene("cornell")))) {
    if (line.rfind("f ", 0) != 0) {
      text += line + "\n";
      continue;
    }
    std::istringstream words(line.substr(2));
    const std::vector<std::string> corners{std::istream_iterator<std::string>(words), {}};
    text += "f";
    std::for_each(corners.rbegin(), corners.rend(), [&](const std::string& c) { text += " " + c; });
    text += "\n";
  }
  write_file(folder / "inside_out.obj", text);
  std::filesystem::copy_file(std::string(FIXRAD_SOURCE_DIR) + "/scenes/cornell.mtl", folder / "cornell.mtl");
  return folder / "inside_out.obj";
}

// A cube whose walls are `cells` x `cells` squares, with a lamp in the middle of the ceiling, less one square
// of the floor if so wanted. Neighbours differ in material, so that they stay apart.
std::string tiled_room(int cells, bool has_hole) {
  SceneText text;
  const double size = 1.0 / cells;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 2 * cells * cells; ++i) {
      const int side = i % 2, u = i / 2 % cells, v = i / 2 / cells;
      SceneText::Corner o = {}, a = {}, b = {};
      o[axis] = side;
      o[(axis + 1) % 3] = u * size;
      o[(axis + 2) % 3] = v * size;
      a[(axis + 1) % 3] = size;
      b[(axis + 2) % 3] = size;
      const bool is_middle = axis == 1 && u == cells / 2 && v == cells / 2;
      if (is_middle && side == 0 && has_hole) {
        continue;
      }
      const char* material = is_middle && side == 1 ? "lamp" : (u + v) % 2 == 0 ? "grey" : "white";
      text.quad(material, o, side == 0 ? a : b, side == 0 ? b : a);
    }
  }
  return text.text();
}

TEST(Explain, NormalsThatPointOutwardAreRecognised) {
  const ScratchFolder folder;
  const std::string scene = inside_out_cornell(folder);
  const Outcome run = run_tool({"bake", scene, "--profile", "small"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("normals probably point outward"));
  EXPECT_THAT(run.err, HasSubstr("--flip"));
  EXPECT_THAT(run.err, HasSubstr("--two-sided"));
}

TEST(Explain, FlipLightsAnInsideOutRoomAsIfItHadBeenRight) {
  const ScratchFolder folder;
  const std::string scene = inside_out_cornell(folder);
  EXPECT_THAT(run_tool({"bake", scene, "--profile", "small", "--flip"}).err, Not(HasSubstr("warning")));
  const auto right = baked_faces(sample_scene("cornell"), {"--profile", "small"});
  const auto flipped = baked_faces(scene, {"--profile", "small", "--flip"});
  ASSERT_EQ(flipped.size(), right.size());
  for (const std::size_t face : {0u, 6u, 7u}) {  // floor and walls; they may be cut the other way
    EXPECT_NEAR(flipped[face].b[1], right[face].b[1], 0.03 * right[face].b[1]) << "face " << face;
  }
}

TEST(Explain, TwoSidedLightsAnInsideOutRoom) {
  const ScratchFolder folder;
  const std::string scene = inside_out_cornell(folder);
  const auto right = baked_faces(sample_scene("cornell"), {"--profile", "small"});
  const auto dark = baked_faces(scene, {"--profile", "small"});
  const auto lit = baked_faces(scene, {"--profile", "medium", "--two-sided"});
  ASSERT_EQ(lit.size(), right.size());
  EXPECT_LT(dark[0].b[0], 0.02 * right[0].b[0]);
  for (const std::size_t face : {0u, 6u, 7u}) {
    EXPECT_NEAR(lit[face].b[1], right[face].b[1], 0.05 * right[face].b[1]) << "face " << face;
  }
}

TEST(Explain, ALampInsideABodyIsRecognisedWithItsLine) {
  const ScratchFolder folder;
  SceneText text;
  text.room("grey", {0, 0, 0}, {1, 1, 1});
  text.body("white", {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
  text.quad("lamp", {0.4, 0.999, 0.4}, {0.2, 0, 0}, {0, 0, 0.2});  // faces down
  const int line = text.quad("bulb", {0.4, 0.5, 0.4}, {0.2, 0, 0}, {0, 0, 0.2});
  const std::string scene = write_scene(folder, text.text());
  const Outcome run = run_tool({"bake", scene, "--profile", "small"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr(scene + ":" + std::to_string(line) + ": warning: "));
  EXPECT_THAT(run.err, HasSubstr("cannot get out"));
  EXPECT_THAT(run.err, Not(HasSubstr("normals probably")));
}

TEST(Explain, ALampThatFacesTheCeilingAboveItIsNotCalledBuried) {
  const Outcome run = run_tool({"bake", sample_scene("indirect_only"), "--profile", "small"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, Not(HasSubstr("warning")));
}

TEST(Explain, AHoleInARoomIsRecognised) {
  const ScratchFolder folder;
  const std::string scene = write_scene(folder, tiled_room(5, true));
  const Outcome run = run_tool({"bake", scene, "--profile", "medium"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("escapes through holes"));
  EXPECT_THAT(run.err, HasSubstr("4 edges belong to one face only"));
}

TEST(Explain, ARoomWithoutHolesIsClosedAndNotComplainedAbout) {
  const ScratchFolder folder;
  const std::string scene = write_scene(folder, tiled_room(5, false));
  EXPECT_THAT(run_tool({"bake", scene, "--profile", "medium"}).err, Not(HasSubstr("warning")));
  const auto json = baked_json(scene, {"--profile", "medium"});
  EXPECT_TRUE(json["closed"].get<bool>());
  EXPECT_EQ(json["ledger"]["escaped"][0], 0);
}

TEST(Explain, ARoomThatIsOpenOnPurposeIsNotComplainedAbout) {
  const Outcome run = run_tool({"bake", sample_scene("cornell"), "--profile", "small"});
  EXPECT_THAT(run.err, Not(HasSubstr("warning")));
}

}  // namespace
}  // namespace fixrad::host::testing

// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/cli/scene_text.h"
#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kRoom =
    "mtllib scene.mtl\n"
    "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\n"  // lines 2 to 5
    "v 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\n"  // lines 6 to 9
    "usemtl grey\nf 1 2 3 4\n"              // 10, 11
    "usemtl lamp\nf 5 6 7 8\n";             // 12, 13

// Exit 1, exactly one line that starts with `place` and says `what`, and no output file.
void expect_refused(const ScratchFolder& folder, const std::string& scene, const std::string& place,
                    const std::string& what, std::vector<std::string> options = {"--profile", "small"}) {
  options.insert(options.begin(), {"bake", scene, "-o", folder / "out.json", "-o", folder / "out.ply",
                                   "--faces-csv", folder / "out.csv"});
  const std::vector<std::string> before = names_in(folder / "");
  const Outcome run = run_tool(options);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  EXPECT_THAT(run.err, StartsWith(place));
  EXPECT_THAT(run.err, HasSubstr("error: "));
  EXPECT_THAT(run.err, HasSubstr(what));
  EXPECT_EQ(names_in(folder / ""), before);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// The small room with one piece of text replaced, refused at a line of scene.obj.
void expect_obj_refused(const std::string& from, const std::string& to, int line, const std::string& what) {
  const ScratchFolder folder;
  const std::string scene = write_scene(folder, replaced(kRoom, from, to));
  expect_refused(folder, scene, scene + ":" + std::to_string(line) + ":", what);
}

void expect_mtl_refused(const std::string& from, const std::string& to, int line, const std::string& what) {
  const ScratchFolder folder;
  const std::string scene = write_scene(folder, kRoom, replaced(kMaterials, from, to));
  expect_refused(folder, scene, (folder / "scene.mtl").string() + ":" + std::to_string(line) + ":", what);
}

TEST(BadInput, TheRoomOfTheseTestsIsGood) {
  const ScratchFolder folder;
  const Outcome run = run_tool({"bake", write_scene(folder, kRoom), "--profile", "small"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(BadInput, MissingFile) {
  const ScratchFolder folder;
  expect_refused(folder, folder / "nowhere.obj", folder / "nowhere.obj: error: ", "");
}

TEST(BadInput, AFolder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "scene.obj");
  expect_refused(folder, folder / "scene.obj", folder / "scene.obj: error: ", "");
}

TEST(BadInput, EmptyFile) {
  const ScratchFolder folder;
  const std::string scene = write_scene(folder, "");
  expect_refused(folder, scene, scene + ":", "");
}

TEST(BadInput, BinaryRubbish) {
  const ScratchFolder folder;
  std::string rubbish =
      "\x7f"
      "ELF";
  for (unsigned i = 0, x = 12345; i < 4096; ++i) {
    x = x * 1103515245u + 12345u;
    rubbish += static_cast<char>(x >> 16 & 0xff);
  }
  const std::string scene = write_scene(folder, rubbish);
  expect_refused(folder, scene, scene + ":", "");
}

TEST(BadInput, AFaceWithAMissingVertex) {
  expect_obj_refused("f 5 6 7 8", "f 5 6 7 9", 13, "9");
}

TEST(BadInput, AFaceWithTwoCorners) {
  expect_obj_refused("f 5 6 7 8", "f 5 6", 13, "corner");
}

TEST(BadInput, AFaceWithNoCorners) {
  expect_obj_refused("f 5 6 7 8", "f", 13, "corner");
}

TEST(BadInput, ACoordinateThatIsNoFiniteNumber) {
  for (const char* value : {"nan", "inf", "-inf", "1e999", "half"}) {
    expect_obj_refused("v 1 0 1", "v 1 " + std::string(value) + " 1", 4, "");
  }
}

TEST(BadInput, ReflectanceOfOneOrMore) {
  expect_mtl_refused("Kd 0.5 0.5 0.5", "Kd 0.5 1 0.5", 2, "--max-reflectance");
  expect_mtl_refused("Kd 0.5 0.5 0.5", "Kd 0.5 0.5 7", 2, "--max-reflectance");
}

TEST(BadInput, NegativeEmission) {
  expect_mtl_refused("Ke 10 10 10", "Ke 10 -1 10", 7, "Ke");
}

TEST(BadInput, NoLampAtAll) {
  const ScratchFolder folder;
  const std::string scene = write_scene(folder, replaced(kRoom, "usemtl lamp\n", ""));
  expect_refused(folder, scene, scene + ":", "Ke");
}

TEST(BadInput, MissingMaterialLibrary) {
  expect_obj_refused("mtllib scene.mtl", "mtllib other.mtl", 1, "other.mtl");
}

TEST(BadInput, MissingMaterial) {
  expect_obj_refused("usemtl grey", "usemtl blue", 10, "blue");
}

TEST(BadInput, AMaterialThatIsNeverUsedIsNoError) {
  const ScratchFolder folder;
  const std::string unused = std::string(kMaterials) + "newmtl mirror\nKd 3 3 3\nKe -1 0 0\n";
  const Outcome run = run_tool({"bake", write_scene(folder, kRoom, unused), "--profile", "small"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(BadInput, ASceneThatDoesNotFitTheProfile) {
  const ScratchFolder folder;
  const std::string scene = sample_scene("colonnade");
  expect_refused(folder, scene, scene + ": error: ", "does not fit profile tiny", {"--profile", "tiny"});
}

}  // namespace
}  // namespace fixrad::host::testing

// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <fstream>
#include <regex>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// The text of `fixrad export SCENE --profile tiny -o FOLDER/NAME OPTIONS...`, which must succeed.
std::string exported(const std::string& scene, const std::string& name,
                     const std::vector<std::string>& options = {}) {
  const ScratchFolder folder;
  std::vector<std::string> arguments = {"export", scene, "--profile", "tiny", "-o", folder / name};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = run_tool(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return contents(folder / name);
}

// What the first group of `pattern` matches in `text`; empty if nothing does.
std::string found(const std::string& text, const std::string& pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string();
}

TEST(Export, ExpectsWhatBakeFinds) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--engine", "pixels"}, {"--overshoot", "--unshot", "0.01"}}) {
    const std::string text = exported(sample_scene("cornell"), "room.h", options);
    std::vector<std::string> same = {"--profile", "tiny"};
    same.insert(same.end(), options.begin(), options.end());
    const nlohmann::json json = baked_json(sample_scene("cornell"), same);
    EXPECT_EQ(found(text, "kDigest = 0x([0-9a-f]{16})ull;"), json["digest"].get<std::string>());
    EXPECT_EQ(found(text, "kShots = ([0-9]+)u;"), std::to_string(json["shots"].get<int>()));
    EXPECT_EQ(found(text, "kEyes = ([0-9]+)u;"), std::to_string(json["eyes"].get<int>()));
    std::string row;
    for (const char* column : {"emitted", "absorbed", "unshot", "escaped", "back"}) {
      row += (row.empty() ? "{" : ", ") + std::to_string(json["ledger"][column][0].get<std::int64_t>());
    }
    EXPECT_THAT(text, HasSubstr("kLedger[][5] = {\n    " + row + "}"));
  }
}

TEST(Export, NamesTheNamespaceAfterTheFile) {
  const std::pair<const char*, const char*> names[] = {
      {"room.h", "room"},         {"my room-2.h", "my_room_2"},  {"7up.hpp", "scene_7up"},
      {"class.h", "scene_class"}, {"fixrad.h", "scene_fixrad"},  {"__.h", "scene"},
      {"a.b.h", "a_b"},           {"z\xc3\xa4hler.h", "z_hler"}, {"int8_t.h", "scene_int8_t"}};
  for (const auto& [file, name] : names) {
    const std::string text = exported(sample_scene("closed_box"), file);
    EXPECT_THAT(text, HasSubstr("\nnamespace " + std::string(name) + " {\n")) << file;
    EXPECT_THAT(text, HasSubstr("\n}  // namespace " + std::string(name) + "\n")) << file;
  }
}

TEST(Export, ASceneNameCannotLeaveItsComment) {
  const ScratchFolder folder;
  const std::string scene = folder / "room\\\n#error.obj";
  std::filesystem::copy_file(sample_scene("closed_box"), scene);
  std::filesystem::copy_file(std::string(FIXRAD_SOURCE_DIR) + "/scenes/closed_box.mtl",
                             folder / "closed_box.mtl");
  const std::string text = exported(scene, "room.h");
  for (const std::string& line : lines_of(text)) {
    EXPECT_THAT(line, ::testing::Not(StartsWith("#error")));
  }
  EXPECT_THAT(lines_of(text).at(2), StartsWith("// The scene of room__#error.obj for profile tiny"));
}

TEST(Export, WritesTheSameBytesAgain) {
  EXPECT_EQ(exported(sample_scene("cornell"), "room.h"), exported(sample_scene("cornell"), "room.h"));
}

TEST(Export, RefusesASceneThatDoesNotFitAndKeepsTheOldFile) {
  const ScratchFolder folder;
  std::ofstream(folder / "room.h") << "old";
  const Outcome run = run_tool(
      {"export", sample_scene("furnished_room"), "--quiet", "--profile", "tiny", "-o", folder / "room.h"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the scene does not fit profile tiny"));
  EXPECT_THAT(names_in(folder / ""), ElementsAre("room.h"));
  EXPECT_EQ(contents(folder / "room.h"), "old");
}

TEST(Export, RefusesAMissingFolderBeforeItReadsTheScene) {
  const ScratchFolder folder;
  const std::string bad = folder / "missing/room.h";
  const Outcome run = run_tool({"export", "nowhere.obj", "-o", bad});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, StartsWith(bad + ": error: "));
}

TEST(Export, RefusesGatheringWhichTheSolverCannotReplay) {
  const ScratchFolder folder;
  const Outcome run =
      run_tool({"export", sample_scene("closed_box"), "--solver", "gathering", "-o", folder / "room.h"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("leave out --solver gathering"));
  EXPECT_TRUE(names_in(folder / "").empty());
}

TEST(Export, OneHeaderIsNeededAndNothingElse) {
  const ScratchFolder folder;
  const std::string scene = sample_scene("closed_box");
  const std::vector<std::vector<std::string>> wrong = {
      {"export"},
      {"export", scene},
      {"export", scene, "-o"},
      {"export", scene, "-o", folder / "room.json"},
      {"export", scene, "-o", folder / "room"},
      {"export", scene, "-o", folder / ".h"},
      {"export", scene, "-o", folder / "a.h", "-o", folder / "b.h"}};
  for (const std::vector<std::string>& arguments : wrong) {
    const Outcome run = run_tool(arguments);
    EXPECT_EQ(run.exit_code, 2) << ::testing::PrintToString(arguments);
    EXPECT_FALSE(run.err.empty());
    EXPECT_TRUE(names_in(folder / "").empty());
  }
}

TEST(Export, InterruptedItWritesNothing) {
  const ScratchFolder folder;
  Tool tool({"export", sample_scene("high_rho"), "--profile", "host", "--unshot", "0.000001", "--elements",
             "6000", "-o", folder / "room.h"});
  ASSERT_TRUE(tool.wait_until_interruptible());
  tool.interrupt();
  const Outcome run = tool.finish();
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(run.err, HasSubstr("interrupted: nothing written"));
  EXPECT_TRUE(names_in(folder / "").empty());
}

}  // namespace
}  // namespace fixrad::host::testing

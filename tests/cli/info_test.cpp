// SPDX-License-Identifier: MIT
// `fixrad info`: the page and its JSON say the same, and it is what the scene is.
#include <gmock/gmock.h>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The blocks of a page, which empty lines separate.
std::vector<std::string> blocks_of(const std::string& page) {
  std::vector<std::string> blocks(1);
  for (const std::string& line : lines_of(page)) {
    if (line.empty()) {
      blocks.emplace_back();
    } else {
      blocks.back() += line + "\n";
    }
  }
  return blocks;
}

struct Info {
  std::vector<std::string> blocks;
  nlohmann::json json;
};

Info info_of(const std::string& scene, const std::vector<std::string>& options = {}) {
  const ScratchFolder folder;
  std::vector<std::string> arguments = {"info", sample_scene(scene), "--json", folder / "info.json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = run_tool(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return {blocks_of(run.out), nlohmann::json::parse(contents(folder / "info.json"))};
}

TEST(Info, SaysWhatTheSceneNeedsOnEachProfile) {
  const Outcome run = run_tool({"info", sample_scene("colonnade"), "--profile", "small"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("span pool"));
  EXPECT_THAT(run.out, HasSubstr("grey: one channel"));
  for (const char* profile : {"tiny", "small", "medium", "large"}) {
    EXPECT_THAT(run.out, HasSubstr("\n  " + std::string(profile) + " "));
  }
  EXPECT_THAT(run.out, HasSubstr("does not fit"));  // 58 faces on 6 KB
}

TEST(Info, EndsWithTheMemoryOfTheProfiles) {
  const Info info = info_of("closed_box", {"--profile", "tiny"});
  ASSERT_EQ(info.blocks.size(), 3u);
  EXPECT_THAT(info.blocks[1], HasSubstr("left out because of that"));
  EXPECT_EQ(lines_of(info.blocks[2]).size(), 1u + 5u);
  EXPECT_THAT(info.blocks[2], HasSubstr("RAM used"));
  ASSERT_EQ(info.json["profiles"].size(), 5u);
  for (const auto& profile : info.json["profiles"]) {
    EXPECT_LE(profile["ram_bytes"].get<unsigned>(), profile["limit"].get<unsigned>());
  }
}

TEST(Info, TellsAConvexSceneFromOneInWhichFacesHideEachOther) {
  const Info box = info_of("closed_box", {"--profile", "tiny"});
  EXPECT_TRUE(box.json["needs"]["convex"].get<bool>());
  EXPECT_THAT(box.blocks[0], HasSubstr("the scene is convex"));
  EXPECT_THAT(box.blocks[1], HasSubstr("depth of faces"));
  const Info cornell = info_of("cornell", {"--profile", "tiny"});
  EXPECT_FALSE(cornell.json["needs"]["convex"].get<bool>());
  EXPECT_THAT(cornell.blocks[0], HasSubstr("faces hide each other"));
  EXPECT_THAT(cornell.blocks[1], Not(HasSubstr("depth of faces")));
  EXPECT_THAT(cornell.blocks[1], HasSubstr("backs of 10 faces"));
}

TEST(Info, CountsOnTheCoreOfTheProfileOrOnTheOneThatIsAskedFor) {
  EXPECT_EQ(info_of("closed_box", {"--profile", "tiny"}).json["target"], "atmega2560");
  const Info asked = info_of("closed_box", {"--profile", "tiny", "--target", "rv32imc"});
  EXPECT_EQ(asked.json["target"], "rv32imc");
  EXPECT_THAT(asked.blocks[1], HasSubstr("instructions on rv32imc"));
  EXPECT_EQ(run_tool({"info", sample_scene("closed_box"), "--target", "z80"}).exit_code, 2);
}

TEST(Info, FindsElementsForAWantedErrorAndMoreOfThemForASmallerOne) {
  const Info coarse = info_of("parallel_plates", {"--profile", "tiny", "--max-error", "10"});
  const Info fine = info_of("parallel_plates", {"--profile", "tiny", "--max-error", "1"});
  ASSERT_EQ(fine.blocks.size(), 4u);
  EXPECT_THAT(fine.blocks[2], HasSubstr("mean error of at most 1 %"));
  const auto& enough = fine.json["wanted_error"]["enough"];
  EXPECT_LE(enough["mean_error"].get<double>(), 0.01);
  EXPECT_GT(fine.json["wanted_error"]["too_few"]["mean_error"].get<double>(), 0.01);
  EXPECT_LE(coarse.json["wanted_error"]["enough"]["elements"].get<int>(), enough["elements"].get<int>());
}

TEST(Info, RefusesAFileInAFolderThatDoesNotExist) {
  const Outcome run = run_tool({"info", sample_scene("closed_box"), "--json", "/nowhere/info.json"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("/nowhere"));
}

}  // namespace
}  // namespace fixrad::host::testing

// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Usage, UnknownSuffixIsAUsageErrorAndWritesNothing) {
  const ScratchFolder folder;
  for (const char* name : {"room.obj", "room", "room.jsonx", ".ply"}) {
    const Outcome run = run_tool({"bake", sample_scene("closed_box"), "--profile", "tiny", "-o",
                                  folder / "good.ply", "-o", folder / name});
    EXPECT_EQ(run.exit_code, 2) << name;
    EXPECT_THAT(run.err, HasSubstr(".hpp .glb .ply .png .csv .json"));
    EXPECT_TRUE(names_in(folder / "").empty()) << name;
  }
}

TEST(Usage, MissingArgumentsAreUsageErrors) {
  const std::vector<std::vector<std::string>> incomplete = {
      {}, {"bake"}, {"bake", sample_scene("closed_box"), "-o"}, {"form-factors", sample_scene("closed_box")}};
  for (const auto& arguments : incomplete) {
    const Outcome run = run_tool(arguments);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_FALSE(run.err.empty());
  }
}

TEST(Usage, ValuesOutOfRangeAreUsageErrors) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"--profile", "huge"},      {"--engine", "guess"},      {"--solver", "magic"}, {"--resolution", "17"},
      {"--unshot", "0"},          {"--unshot", "nan"},        {"--elements", "0"},   {"--elements", "-5"},
      {"--exposure", "infinity"}, {"--max-reflectance", "1"}, {"--up", "x"}};
  for (const auto& [option, value] : wrong) {
    EXPECT_EQ(run_tool({"bake", sample_scene("closed_box"), option, value}).exit_code, 2)
        << option << ' ' << value;
  }
  EXPECT_EQ(run_tool({"bake", sample_scene("closed_box"), "--no-such-option"}).exit_code, 2);
}

TEST(Usage, HelpNamesTheSubcommandsAndSucceeds) {
  const Outcome run = run_tool({"--help"});
  EXPECT_EQ(run.exit_code, 0);
  for (const char* name : {"bake", "compare", "export", "form-factors", "info", "truth"}) {
    EXPECT_THAT(run.out, HasSubstr(name));
  }
}

TEST(Usage, QuietSilencesAllButErrorsBeforeAndAfterTheSubcommand) {
  const std::string scene = sample_scene("cornell");
  const Outcome before = run_tool({"--quiet", "bake", scene, "--profile", "tiny"});
  const Outcome after = run_tool({"bake", "--quiet", scene, "--profile", "tiny"});
  for (const Outcome& run : {before, after}) {
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "");
  }
  EXPECT_NE(run_tool({"--quiet", "bake", "nowhere.obj"}).err, "");
}

TEST(Usage, LogFilesGetPlainLines) {
  const Outcome run = run_tool({"bake", sample_scene("cornell"), "--profile", "small"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_FALSE(run.err.empty());
  EXPECT_THAT(run.err, Not(HasSubstr("\r")));
  EXPECT_THAT(run.err, Not(HasSubstr("\033")));
}

}  // namespace
}  // namespace fixrad::host::testing

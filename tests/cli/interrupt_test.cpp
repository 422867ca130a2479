// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Minutes of work: ten reflections, thousands of elements, a millionth of the light left.
const std::vector<std::string> kLong = {
    "bake", sample_scene("high_rho"), "--profile", "host", "--unshot", "0.000001", "--elements", "6000"};

Outcome interrupted(std::vector<std::string> options) {
  options.insert(options.begin(), kLong.begin(), kLong.end());
  Tool tool(options);
  EXPECT_TRUE(tool.wait_until_interruptible());
  tool.interrupt();
  return tool.finish();
}

TEST(Interrupt, WritesNothingAndSaysSo) {
  const ScratchFolder folder;
  const Outcome run = interrupted({"-o", folder / "room.json", "-o", folder / "room.ply"});
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(run.err, HasSubstr("interrupted: nothing written"));
  EXPECT_THAT(run.err, HasSubstr("--keep-partial"));
  EXPECT_TRUE(names_in(folder / "").empty());
}

TEST(Interrupt, KeepsTheSolutionSoFarOnlyIfAsked) {
  const ScratchFolder folder;
  const Outcome run = interrupted({"--keep-partial", "-o", folder / "room.json"});
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(run.err, HasSubstr("solution so far"));
  ASSERT_THAT(names_in(folder / ""), ElementsAre("room.json"));
  const auto json = nlohmann::json::parse(contents(folder / "room.json"));
  EXPECT_TRUE(json["interrupted"].get<bool>());
  EXPECT_GT(json["unshot_fraction"].get<double>(), 0.000001);
  const auto& ledger = json["ledger"];
  const auto at = [&](const char* column) { return ledger[column][0].get<std::int64_t>(); };
  EXPECT_EQ(at("emitted"), at("absorbed") + at("unshot") + at("escaped") + at("back"));
}

TEST(Interrupt, StopsFormFactorsToo) {
  const ScratchFolder folder;
  Tool tool({"form-factors", sample_scene("furnished_room"), "--elements", "6000", "--resolution", "128",
             "--csv", folder / "factors.csv"});
  ASSERT_TRUE(tool.wait_until_interruptible());
  tool.interrupt();
  EXPECT_EQ(tool.finish().exit_code, 130);
  EXPECT_TRUE(names_in(folder / "").empty());
}

TEST(Interrupt, StopsCompareInItsReferencesToo) {
  const ScratchFolder folder;
  Tool tool({"compare", sample_scene("cornell"), "--profile", "tiny", "--json", folder / "errors.json"});
  ASSERT_TRUE(tool.wait_until_interruptible());
  // The fixed-point solution takes some hundredths of a second, the references seconds.
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  tool.interrupt();
  const Outcome run = tool.finish();
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(names_in(folder / "").empty());
}

}  // namespace
}  // namespace fixrad::host::testing

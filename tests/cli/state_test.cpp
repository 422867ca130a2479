// SPDX-License-Identifier: MIT
// Solutions that are saved, shown and resumed, by the tool and by devices.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// What the emulated devices have written (firmware/apps/resume), and the options of these scenes
// (scripts/export_scenes.sh).
struct DeviceState {
  std::string file;
  std::vector<std::string> options;
};

const DeviceState kCortexM0 = {FIXRAD_SOURCE_DIR "/tests/targets/saved/cornell_small_75.fxrs",
                               {"--profile", "small"}};
const DeviceState kAtmega2560 = {FIXRAD_SOURCE_DIR "/tests/targets/saved/cornell_tiny_75.fxrs",
                                 {"--profile", "tiny", "--elements", "120", "--flux-per-row", "0.00055"}};

// `fixrad bake cornell OPTIONS... MORE...`.
Outcome bake(std::vector<std::string> options, const std::vector<std::string>& more) {
  options.insert(options.begin(), {"bake", sample_scene("cornell")});
  options.insert(options.end(), more.begin(), more.end());
  return run_tool(options);
}

void write(const std::string& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

// All that was measured but the time and what was not done here.
nlohmann::json without_times(nlohmann::json json) {
  json.erase("seconds");
  json.erase("display_seconds");
  return json;
}

TEST(State, OfADeviceIsResumedToTheSameEnd) {
  for (const DeviceState& device : {kCortexM0, kAtmega2560}) {
    const ScratchFolder folder;
    std::vector<std::string> resumed = device.options;
    resumed.insert(resumed.end(), {"--resume", device.file});
    const nlohmann::json whole = baked_json(sample_scene("cornell"), device.options);
    const nlohmann::json rest = baked_json(sample_scene("cornell"), resumed);
    EXPECT_EQ(without_times(rest), without_times(whole));
    EXPECT_GT(whole["shots"].get<int>(), 75);
  }
}

TEST(State, OfTheToolIsThatOfADeviceByteForByte) {
  for (const DeviceState& device : {kCortexM0, kAtmega2560}) {
    const ScratchFolder folder;
    const Outcome run = bake(device.options, {"--shots", "75", "--save", folder / "room.fxrs"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(names_in(folder / ""), ElementsAre("room.fxrs"));
    EXPECT_TRUE(contents(folder / "room.fxrs") == contents(device.file));
  }
}

TEST(State, IsShownWithoutItsScene) {
  const ScratchFolder folder;
  const Outcome run = run_tool({"state", kCortexM0.file, "--json", folder / "state.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* part : {"format 1, 4740 bytes, checksum right", "254 elements on 20 faces, 3 channels",
                           "75 from 181 eye points", "elements shoot"}) {
    EXPECT_THAT(run.out, HasSubstr(part));
  }
  const auto json = nlohmann::json::parse(contents(folder / "state.json"));
  std::vector<std::string> options = kCortexM0.options;
  options.insert(options.end(), {"--shots", "75"});
  const nlohmann::json baked = baked_json(sample_scene("cornell"), options);
  for (const char* key :
       {"elements", "faces", "channels", "shots", "eyes", "eyes_withdrawn", "gaps_closed", "spans_used"}) {
    EXPECT_EQ(json[key], baked[key]) << key;
  }
  EXPECT_NEAR(json["unshot_fraction"].get<double>(), baked["unshot_fraction"].get<double>(), 1e-9);
  for (const char* column : {"emitted", "absorbed", "unshot", "escaped", "back"}) {
    EXPECT_EQ(json["ledger"][column], baked["ledger"][column]) << column;
  }
  EXPECT_EQ(run_tool({"--quiet", "state", kCortexM0.file}).out, "");
}

TEST(State, IsSavedEverySoManyShotsAndNumbered) {
  const ScratchFolder folder;
  const std::string file = folder / "room.fxrs";
  const std::vector<std::string> every = {"--shots", "50", "--save", file, "--save-every", "10"};
  ASSERT_EQ(bake(kCortexM0.options, every).exit_code, 0);
  const auto read = [&] {
    EXPECT_EQ(run_tool({"state", file, "--json", folder / "state.json"}).exit_code, 0);
    return nlohmann::json::parse(contents(folder / "state.json"));
  };
  EXPECT_EQ(read()["sequence"], 5);  // after 10, 20, .. 50 shots and at the end
  ASSERT_EQ(bake(kCortexM0.options, {"--resume", file, "--save", file, "--shots", "60"}).exit_code, 0);
  EXPECT_EQ(read()["sequence"], 6);
  EXPECT_EQ(read()["shots"], 60);
}

TEST(State, IsKeptWhenTheUserInterrupts) {
  const ScratchFolder folder;
  const std::string file = folder / "room.fxrs";
  const std::vector<std::string> command = {"bake",       sample_scene("high_rho"),
                                            "--profile",  "host",
                                            "--unshot",   "0.000001",
                                            "--elements", "6000",
                                            "--save",     file};
  Tool tool(command);
  ASSERT_TRUE(tool.wait_until_interruptible());
  tool.interrupt();
  const Outcome run = tool.finish();
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(run.err, HasSubstr("--resume " + file));
  ASSERT_THAT(names_in(folder / ""), ElementsAre("room.fxrs"));
  EXPECT_EQ(run_tool({"state", file}).exit_code, 0);
}

// Exit 1 and one line `file: error: what; what to do`, from `state` and from `bake --resume` alike.
void expect_refused(const std::string& file, const std::string& what, const std::string& to_do,
                    bool also_shown = true) {
  const ScratchFolder folder;
  std::vector<Outcome> runs;
  runs.push_back(bake(kCortexM0.options, {"--quiet", "--resume", file, "-o", folder / "room.json"}));
  if (also_shown) {
    runs.push_back(run_tool({"state", file, "--json", folder / "room.json"}));
  }
  for (const Outcome& run : runs) {
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    EXPECT_THAT(run.err, StartsWith(file + ": error: "));
    EXPECT_THAT(run.err, HasSubstr(what));
    EXPECT_THAT(run.err, HasSubstr("; " + to_do));
    EXPECT_TRUE(names_in(folder / "").empty());
  }
}

TEST(State, ThatIsRefusedIsNamedWithWhatToDo) {
  const ScratchFolder folder;
  const std::string file = folder / "room.fxrs", good = contents(kCortexM0.file);
  expect_refused(folder / "nowhere.fxrs", "no such file", "check");
  write(file, "o room\nv 0 0 0\n");
  expect_refused(file, "no saved state", "name a file");
  write(file, good.substr(0, good.size() - 1));
  expect_refused(file, "ends early", "copy all of it");
  std::string damaged = good;
  damaged[1000] = static_cast<char>(damaged[1000] ^ 1);
  write(file, damaged);
  expect_refused(file, "damaged", "copy it again");
  expect_refused(kAtmega2560.file, "another scene", "give the scene", false);
}

TEST(State, OfOtherSettingsIsRefused) {
  const ScratchFolder folder;
  for (const std::vector<std::string>& other : {std::vector<std::string>{"--unshot", "0.01"},
                                                {"--no-overshoot"},
                                                {"--near-field"},
                                                {"--engine", "rows"}}) {
    std::vector<std::string> more = {"--resume", kCortexM0.file, "-o", folder / "room.json"};
    more.insert(more.end(), other.begin(), other.end());
    const Outcome run = bake(kCortexM0.options, more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, HasSubstr("other settings"));
    EXPECT_TRUE(names_in(folder / "").empty());
  }
}

TEST(State, GatheringHasNone) {
  const ScratchFolder folder;
  const Outcome run = bake({"--profile", "large", "--elements", "60", "--solver", "gathering"},
                           {"--save", folder / "room.fxrs"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("leave out --solver gathering"));
  EXPECT_TRUE(names_in(folder / "").empty());
}

TEST(State, AFolderThatIsNotThereIsNamedBeforeAnyWork) {
  const Outcome run = bake(kCortexM0.options, {"--save", "/nowhere/room.fxrs"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("the folder /nowhere does not exist"));
}

}  // namespace
}  // namespace fixrad::host::testing

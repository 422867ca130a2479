// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cstdlib>

#include "host_sim/reference/error_budget.h"
#include "host_sim/sweep/setting.h"
#include "host_sim/sweep/truth.h"
#include "tests/bake/sample.h"
#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(TuneCommand, PrintsACommandThatKeepsItsPromiseWhenRun) {
  const ScratchFolder folder;
  const Outcome run = run_tool({"tune", sample_scene("portico"), "--target", "cortex-m0", "--ram", "6000",
                                "--max-error", "3", "--json", folder / "tuned.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ASSERT_THAT(lines_of(run.out), SizeIs(1));
  const std::string command = lines_of(run.out).front() + " --quiet -o " + shell_word(folder / "baked.json") +
                              " --faces-csv " + shell_word(folder / "faces.csv");
  ASSERT_EQ(std::system(command.c_str()), 0) << command;

  const auto baked = nlohmann::json::parse(contents(folder / "baked.json"));
  EXPECT_LE(baked["ram_bytes"].get<int>(), 6000);
  const auto scene = sample("portico");
  const Truth truth = trace_truth(scene->prepared);
  std::vector<glm::dvec3> means;
  for (const std::string& line : lines_of(contents(folder / "faces.csv"))) {
    if (line.rfind("face,", 0) != 0) {
      const std::string radiosity = line.substr(line.find(',', line.find(',', line.find(',') + 1) + 1) + 1);
      glm::dvec3 b;
      ASSERT_EQ(std::sscanf(radiosity.c_str(), "%lf,%lf,%lf", &b.x, &b.y, &b.z), 3) << line;
      means.push_back(b);
    }
  }
  const double error = compare_face_means(means, truth.means, truth.areas, truth.emits).mean;
  EXPECT_LE(error, 0.03);
  const auto tuned = nlohmann::json::parse(contents(folder / "tuned.json"));
  EXPECT_NEAR(error, tuned["cheapest"]["mean_error"].get<double>(), 1e-9);
}

TEST(TuneCommand, SaysByHowMuchAWishIsOutOfReach) {
  const Outcome run = run_tool({"tune", sample_scene("parallel_plates"), "--target", "cortex-m0", "--ram",
                                "900", "--max-error", "0.1"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err,
              HasSubstr("parallel_plates.obj: error: 0.1 % mean error is out of reach in 900 bytes"));
  EXPECT_THAT(run.err, HasSubstr("closest within these: "));
  EXPECT_THAT(run.err, HasSubstr("for that error: "));
  EXPECT_THAT(run.err, HasSubstr(" bake "));
}

TEST(TuneCommand, KnowsNoOtherTargetsThanTheMeasuredOnes) {
  EXPECT_EQ(run_tool({"tune", sample_scene("cornell"), "--target", "z80"}).exit_code, 2);
}

TEST(SweepCommand, InterruptedWritesNothing) {
  const ScratchFolder folder;
  Tool tool({"sweep", sample_scene("furnished_room"), "-o", folder / "sweep.csv"});
  ASSERT_TRUE(tool.wait_until_interruptible());
  tool.interrupt();
  const Outcome run = tool.finish();
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(run.err, HasSubstr("interrupted: nothing written"));
  EXPECT_THAT(names_in(folder / ""), IsEmpty());
}

TEST(SweepCommand, SaysThatASceneFitsNoneOfTheProfiles) {
  const ScratchFolder folder;
  const Outcome run = run_tool({"sweep", sample_scene("furnished_room"), "--profile", "tiny", "--engine",
                                "pixels", "--resolution", "128", "-o", folder / "sweep.csv"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("furnished_room.obj: error: the scene fits none of these profiles"));
}

}  // namespace
}  // namespace fixrad::host::testing

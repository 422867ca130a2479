// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;

// In the closed box, of one reflectance, the error bound is what happens.
void expect_tight_bound(const nlohmann::json& channel) {
  const double bound = channel["error_bound"].get<double>(), distance = channel["distance"].get<double>();
  const double absorbed = 1 - channel["largest_reflectance"].get<double>();
  EXPECT_LE(distance, bound);
  EXPECT_GE(distance, 0.98 * bound);
  EXPECT_NEAR(bound * absorbed / channel["unshot"].get<double>(), 1.0, 0.01);
}

TEST(Compare, PrintsTheErrorBudgetLineByLineAndTheErrorBoundBesideTheDistance) {
  const ScratchFolder folder;
  const Outcome run = run_tool({"compare", sample_scene("closed_box"), "--profile", "tiny", "--no-overshoot",
                                "--json", folder / "errors.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(contents(folder / "errors.json"));
  ASSERT_EQ(json["errors"].size(), 4u);
  const char* names[] = {"arithmetic", "form factors", "mesh", "total"};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_THAT(run.out, HasSubstr("\n  " + std::string(names[k]) + " "));
    EXPECT_EQ(json["errors"][k]["name"], names[k]);
    EXPECT_GE(json["errors"][k]["mean"].get<double>(), 0.0);
    EXPECT_GE(json["errors"][k]["worst"].get<double>(), 0.0);
    EXPECT_GE(json["errors"][k]["seconds"].get<double>(), 0.0);
    EXPECT_LT(json["errors"][k]["worst_face"].get<int>(), 6);
    const std::string address = std::to_string(json["errors"][k]["worst_face"].get<int>()) + " " +
                                json["errors"][k]["worst_material"].get<std::string>() + "\n";
    EXPECT_THAT(run.out, HasSubstr(address));
  }
  EXPECT_LE(json["errors"][0]["mean"].get<double>(), 0.0015);
  EXPECT_LE(json["errors"][0]["worst"].get<double>(), 0.015);
  EXPECT_THAT(run.out, HasSubstr("error bound "));
  EXPECT_THAT(run.out, HasSubstr("distance to the converged solution "));
  ASSERT_EQ(json["convergence"].size(), 1u);
  expect_tight_bound(json["convergence"][0]);
}

TEST(Compare, ItsTwoIndependentReferencesAgree) {
  const ScratchFolder folder;
  const Outcome run =
      run_tool({"compare", sample_scene("cornell"), "--profile", "tiny", "--json", folder / "errors.json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(contents(folder / "errors.json"));
  EXPECT_TRUE(json["refined"]["settled"].get<bool>());
  EXPECT_LE(json["refined"]["change"].get<double>(), 0.001);
  EXPECT_LE(json["truth_standard_error"].get<double>(), 0.001);
  // No more apart than what is left of the mesh error and two standard errors.
  EXPECT_LE(json["refined"]["against_truth"].get<double>(), 0.003);
}

TEST(Compare, MeasuresIrradianceAtPointsAndKeepsTheTruth) {
  const ScratchFolder folder;
  const std::vector<std::string> command = {"compare",
                                            sample_scene("parallel_plates"),
                                            "--elements",
                                            "60",
                                            "--points",
                                            "64",
                                            "--points-only",
                                            "--points-truth",
                                            folder / "truth.json",
                                            "--json",
                                            folder / "errors.json"};
  const Outcome run = run_tool(command);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto points = nlohmann::json::parse(contents(folder / "errors.json"))["points"];
  EXPECT_EQ(points["count"], 64);
  const char* names[] = {"flat", "mean", "corners", "gather", "at the point"};
  ASSERT_EQ(points["errors"].size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(points["errors"][k]["name"], names[k]);
    EXPECT_THAT(run.out, HasSubstr("\n  " + std::string(names[k]) + " "));
  }
  EXPECT_LE(points["errors"][3]["mean"].get<double>(), 0.02);
  const std::string truth = contents(folder / "truth.json");
  ASSERT_EQ(run_tool(command).exit_code, 0);
  EXPECT_EQ(contents(folder / "truth.json"), truth);
  const auto again = nlohmann::json::parse(contents(folder / "errors.json"))["points"];
  EXPECT_EQ(again["errors"][3]["mean"], points["errors"][3]["mean"]);
}

TEST(Compare, RefusesATruthOfOtherPoints) {
  const ScratchFolder folder;
  const std::string file = folder / "truth.json";
  ASSERT_EQ(run_tool({"compare", sample_scene("parallel_plates"), "--points", "16", "--points-only",
                      "--points-truth", file})
                .exit_code,
            0);
  const Outcome run = run_tool(
      {"compare", sample_scene("closed_box"), "--points", "16", "--points-only", "--points-truth", file});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err,
              HasSubstr(file + ": error: the points are of another scene or number; delete the file"));
}

TEST(Compare, RefusesWhatCannotBeReplayed) {
  const Outcome run = run_tool({"compare", sample_scene("closed_box"), "--solver", "gathering"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(lines_of(run.err).size(), 1u);
}

}  // namespace
}  // namespace fixrad::host::testing

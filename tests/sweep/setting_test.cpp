// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "host_sim/sweep/sweep.h"
#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

TEST(ShellWord, LeavesPlainPathsAloneAndQuotesTheRest) {
  EXPECT_EQ(shell_word("scenes/cornell.obj"), "scenes/cornell.obj");
  EXPECT_EQ(shell_word("my room.obj"), "'my room.obj'");
  EXPECT_EQ(shell_word("a'b"), "'a'\\''b'");
  EXPECT_EQ(shell_word("$(reboot)"), "'$(reboot)'");
  EXPECT_EQ(shell_word(""), "''");
}

TEST(ShortValue, HasThreeDigits) {
  EXPECT_EQ(short_value(0.0001568627), 0.000157);
  EXPECT_EQ(short_value(0.5), 0.5);
}

TEST(Settings, AreAllCombinationsThatFit) {
  const auto scene = sample("cornell");
  const Choices choices = {{"tiny", "medium"}, {"lunes", "rows"}, {16, 32}, {0.0002, 0.001}, {0.1, 0.3}, {}};
  EXPECT_THAT(all_settings(scene->prepared, BakeOptions{}, choices), SizeIs(2 * 2 * 2 * 2 * 2));
}

TEST(Settings, LeaveOutWhatDoesNotFit) {
  const auto scene = sample("cornell");
  const Choices choices = {{"tiny"}, {"pixels"}, {128}, {0.001}, {}, {}};  // 64 KB of pixels
  EXPECT_THAT(all_settings(scene->prepared, BakeOptions{}, choices), SizeIs(0));
}

TEST(Settings, CountOnePlanOnce) {
  const auto scene = sample("closed_box");
  // Six faces: both make 96 elements.
  const Choices choices = {{"tiny"}, {"lunes"}, {16}, {0.001}, {}, {96, 97}};
  EXPECT_THAT(all_settings(scene->prepared, BakeOptions{}, choices), SizeIs(1));
}

TEST(Settings, GiveEachEngineOnlyTheResolutionsThatItHas) {
  const auto scene = sample("closed_box");
  const Choices choices = {{"small"}, {"lunes", "rays"}, {4, 64}, {0.001}, {}, {}};
  const std::vector<BakeOptions> settings = all_settings(scene->prepared, BakeOptions{}, choices);
  ASSERT_THAT(settings, SizeIs(2));
  EXPECT_EQ(settings[0].engine + std::to_string(*settings[0].resolution), "lunes64");
  EXPECT_EQ(settings[1].engine + std::to_string(*settings[1].resolution), "rays4");
}

TEST(Settings, HaveContoursOnceAndOnlyWhereNoFaceHidesAnother) {
  const Choices choices = {{"small"}, {"contour"}, {16, 32}, {0.001}, {}, {}};
  EXPECT_THAT(all_settings(sample("closed_box")->prepared, BakeOptions{}, choices), SizeIs(1));
  EXPECT_THAT(all_settings(sample("cornell")->prepared, BakeOptions{}, choices), SizeIs(0));
}

TEST(Settings, SpreadTheRowsOfLunesRoundTheProfilesChoice) {
  const auto scene = sample("closed_box");
  const BakeOptions own = on_profile("small");
  const double flux = flux_per_row(own, make_plan(scene->prepared, own));
  const std::vector<BakeOptions> settings =
      all_settings(scene->prepared, own, {{"small"}, {"lunes"}, {64}, {}, {}, {}});
  ASSERT_THAT(settings, SizeIs(5));
  double factor = 4;
  for (const BakeOptions& options : settings) {
    EXPECT_NEAR(*options.flux_per_row, factor * flux, 0.005 * factor * flux);
    factor /= 2;
  }
}

TEST(Settings, AsOptionsNameEverythingThatIsNotTheProfilesChoice) {
  const auto scene = sample("closed_box");
  BakeOptions options = on_profile("small");
  options.resolution = 16;
  options.elements = 50;
  options.unshot = 0.01;
  options.ambient = true;
  options.overshoot = false;
  options.near_field = true;
  options.flux_per_row = 0.00016;
  EXPECT_EQ(bake_options_text(options, make_plan(scene->prepared, options)),
            "--profile small --engine lunes --resolution 16 --elements 50 --flux-per-row 0.00016 "
            "--unshot 0.01 --no-overshoot --near-field --ambient");
  options = on_profile("small");
  options.engine = "contour";
  options.flux_per_eye = 0.05;
  EXPECT_EQ(bake_options_text(options, make_plan(scene->prepared, options)),
            "--profile small --engine contour --flux-per-eye 0.05");
}

TEST(Settings, SolvedTwiceGiveTheSameFiguresButForTheTime) {
  const auto scene = sample("cornell");
  Truth truth;
  truth.means.assign(scene->model.faces.size(), glm::dvec3(1.0));
  truth.areas = face_areas(scene->model);
  truth.emits.assign(scene->model.faces.size(), false);
  const SweepPoint a = solve_setting(scene->prepared, truth, on_profile("small"), {});
  const SweepPoint b = solve_setting(scene->prepared, truth, on_profile("small"), {});
  EXPECT_EQ(a.digest, b.digest);
  EXPECT_EQ(a.work, b.work);
  EXPECT_EQ(a.mean_error, b.mean_error);
  EXPECT_GT(a.mean_error, 0);
  EXPECT_EQ(a.command, b.command);
}

TEST(SweepCsv, LeavesACostEmptyThatNoModelGives) {
  SweepPoint point;
  point.options.engine = "rays";
  const std::string text = sweep_csv({point}, "fixrad bake 'a, b.obj'");
  EXPECT_THAT(text, StartsWith("profile,engine,resolution,flux_per_row,flux_per_eye,"));
  EXPECT_THAT(text, HasSubstr(",,,,,,,,"));
  EXPECT_THAT(text, HasSubstr("\"fixrad bake 'a, b.obj' "));
}

}  // namespace
}  // namespace fixrad::host::testing

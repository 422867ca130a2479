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

TEST(Settings, AreAllCombinationsThatFit) {
  const auto scene = sample("cornell");
  const Choices choices = {{"tiny", "medium"}, {"lunes", "rows"}, {16, 32}, {0.006, 0.03}, {}};
  EXPECT_THAT(all_settings(scene->prepared, BakeOptions{}, choices), SizeIs(2 * 2 * 2 * 2));
}

TEST(Settings, LeaveOutWhatDoesNotFit) {
  const auto scene = sample("cornell");
  const Choices choices = {{"tiny"}, {"pixels"}, {128}, {0.006}, {}};  // 64 KB of pixels
  EXPECT_THAT(all_settings(scene->prepared, BakeOptions{}, choices), SizeIs(0));
}

TEST(Settings, CountOnePlanOnce) {
  const auto scene = sample("closed_box");
  const Choices choices = {{"tiny"}, {"lunes"}, {16}, {0.006}, {96, 97}};  // six faces: both make 96 elements
  EXPECT_THAT(all_settings(scene->prepared, BakeOptions{}, choices), SizeIs(1));
}

TEST(Settings, AsOptionsNameEverythingThatIsNotTheProfilesChoice) {
  const auto scene = sample("closed_box");
  BakeOptions options = on_profile("small");
  options.elements = 50;
  options.unshot = 0.01;
  options.ambient = true;
  options.overshoot = false;
  EXPECT_EQ(bake_options_text(options, make_plan(scene->prepared, options)),
            "--profile small --engine lunes --resolution 16 --elements 50 --flux-per-eye 0.006 --unshot 0.01 "
            "--no-overshoot --ambient");
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
  EXPECT_THAT(text, StartsWith("profile,engine,resolution,"));
  EXPECT_THAT(text, HasSubstr(",,,,,,,,"));
  EXPECT_THAT(text, HasSubstr("\"fixrad bake 'a, b.obj' "));
}

}  // namespace
}  // namespace fixrad::host::testing

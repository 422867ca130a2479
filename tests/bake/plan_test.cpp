// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;

TEST(Plan, FitsEveryProfileThatTakesTheScene) {
  for (const char* name : {"cornell", "small_lamp", "gap"}) {
    const auto scene = sample(name);
    for (const Profile& profile : profiles()) {
      const BakePlan plan = make_plan(scene->prepared, on_profile(profile.name));
      EXPECT_LE(plan.ram(), profile.ram_bytes) << name << " on " << profile.name;
      EXPECT_EQ(plan.resolution, profile.lunes);
      EXPECT_EQ(plan.sizes.elements, plan.meshing.element_count);
      EXPECT_GE(plan.sizes.elements, plan.sizes.faces) << "at least one element a face";
      EXPECT_LE(plan.meshing.patch_count, plan.sizes.elements);
    }
  }
}

TEST(Plan, LargerProfilesTakeMoreElements) {
  const auto scene = sample("cornell");
  std::uint32_t last = 0;
  for (const Profile& profile : profiles()) {
    const std::uint32_t elements = make_plan(scene->prepared, on_profile(profile.name)).sizes.elements;
    EXPECT_GT(elements, last) << profile.name;
    last = elements;
  }
}

TEST(Plan, SaysWhatASceneThatDoesNotFitNeeds) {
  const auto scene = sample("furnished_room");
  try {
    make_plan(scene->prepared, on_profile("small"));
    ADD_FAILURE() << "hundreds of faces do not fit 13 KB";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("does not fit profile small"));
    EXPECT_THAT(error.what(), HasSubstr("bytes of 13312"));
    EXPECT_THAT(error.what(), HasSubstr("--profile"));
  }
}

TEST(Plan, GatheringCountsItsMatrix) {
  const auto scene = sample("cornell");
  BakeOptions options = on_profile("large");
  options.elements = 200;
  const BakePlan shooting = make_plan(scene->prepared, options);
  options.solver = "gathering";
  const BakePlan gathering = make_plan(scene->prepared, options);
  const std::uint32_t n = gathering.sizes.elements;
  EXPECT_EQ(shooting.matrix_bytes, 0u);
  EXPECT_GE(gathering.matrix_bytes, 2 * n * n);
  EXPECT_GT(gathering.ram(), shooting.ram());
}

TEST(Plan, GatheringMeshesCoarserWhereTheMatrixWouldNotFit) {
  const auto scene = sample("cornell");
  BakeOptions options = on_profile("medium");
  options.solver = "gathering";
  const BakePlan plan = make_plan(scene->prepared, options);
  EXPECT_LE(plan.ram(), plan.profile.ram_bytes);
  EXPECT_LT(plan.sizes.elements, 60u * 1024 / 2);
  EXPECT_GE(plan.sizes.elements, 100u);
}

TEST(Plan, PixelsPayForTheirItemBuffer) {
  const auto scene = sample("cornell");
  BakeOptions options = on_profile("medium");
  const BakePlan rows = make_plan(scene->prepared, options);
  options.engine = "pixels";
  const BakePlan pixels = make_plan(scene->prepared, options);
  EXPECT_EQ(rows.sizes.pixel_resolution, 0u);
  EXPECT_EQ(pixels.sizes.pixel_resolution, static_cast<std::uint32_t>(pixels.resolution));
  EXPECT_LE(pixels.ram(), pixels.profile.ram_bytes);
}

TEST(Plan, SettingsCarryTheChosenFractionsAndTable) {
  const auto scene = sample("cornell");
  BakeOptions options = on_profile("small");
  options.unshot = 0.25;
  options.flux_per_eye = 0.5;
  options.flux_per_row = 0.125;
  const Settings settings = make_settings(options, make_plan(scene->prepared, options));
  EXPECT_EQ(settings.stop.raw, 0x40000000u);
  EXPECT_EQ(settings.flux_per_eye.raw, 0x80000000u);
  EXPECT_EQ(settings.flux_per_row.raw, 0x20000000u);
  EXPECT_EQ(settings.tables, kLunes);
  EXPECT_EQ(1 << settings.tables[settings.table_count - 1].resolution_log2, find_profile("small")->lunes);
  EXPECT_EQ(settings.engine, lune_rows);
}

}  // namespace
}  // namespace fixrad::host::testing

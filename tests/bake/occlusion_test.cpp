// SPDX-License-Identifier: MIT
#include "host_sim/bake/occlusion.h"

#include <gmock/gmock.h>

#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;

TEST(Occlusion, IsFoundWhereSomethingStandsInARoom) {
  for (const char* name : {"cornell", "portico", "gap", "indirect_only", "furnished_room"}) {
    EXPECT_TRUE(find_occlusion(sample(name)->prepared)) << name;
  }
}

TEST(Occlusion, IsNotFoundInConvexRoomsAndBetweenTwoPlates) {
  for (const char* name : {"closed_box", "unit_cube_one_emitter", "parallel_plates", "white_room"}) {
    EXPECT_FALSE(find_occlusion(sample(name)->prepared)) << name;
  }
}

TEST(Plan, RefusesContoursWhereFacesHideEachOther) {
  BakeOptions options = on_profile("small");
  options.engine = "contour";
  try {
    make_plan(sample("portico")->prepared, options);
    ADD_FAILURE() << "columns hide the wall";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("portico.obj:"));
    EXPECT_THAT(error.what(), HasSubstr("use --engine rays or lunes"));
  }
  EXPECT_EQ(make_settings(options, make_plan(sample("closed_box")->prepared, options)).engine, contour_row);
}

TEST(Plan, GivesRaysTheirOwnResolutions) {
  const auto scene = sample("cornell");
  BakeOptions options = on_profile("small");
  options.engine = "rays";
  EXPECT_EQ(make_settings(options, make_plan(scene->prepared, options)).tables, kLunes + 2);
  options.resolution = 4;
  const Settings settings = make_settings(options, make_plan(scene->prepared, options));
  EXPECT_EQ(settings.engine, ray_row);
  EXPECT_EQ(settings.tables, kLunes);
  EXPECT_EQ(settings.table_count, 1);
  EXPECT_TRUE(has_resolution("rays", 32) && has_resolution("lunes", 8));
  EXPECT_FALSE(has_resolution("rays", 64) || has_resolution("rows", 4));
}

}  // namespace
}  // namespace fixrad::host::testing

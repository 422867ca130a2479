// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> explained(const Sample& scene, const std::string& profile = "small") {
  return explain(scene.prepared, bake(scene.prepared, on_profile(profile)));
}

TEST(ExplainResult, HasNothingToSayAboutGoodScenes) {
  for (const char* name : {"cornell", "closed_box", "small_lamp", "indirect_only", "gap", "colonnade"}) {
    EXPECT_THAT(explained(*sample(name)), IsEmpty()) << name;
  }
}

TEST(ExplainResult, ARoomTurnedInsideOutIsBlackAndItsLightEscapes) {
  ReadOptions options;
  options.flip = true;
  for (const char* name : {"cornell", "unit_cube_one_emitter"}) {
    EXPECT_THAT(explained(*sample(name, options)), Contains(HasSubstr("normals probably point outward")))
        << name;
  }
}

}  // namespace
}  // namespace fixrad::host::testing

// SPDX-License-Identifier: MIT
#include "host_sim/sweep/needs.h"

#include <gmock/gmock.h>

#include "host_sim/sweep/element_search.h"
#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

using ::testing::ElementsAre;

SceneNeeds needs_of(const std::string& scene) {
  return find_needs(sample(scene)->prepared, on_profile("small"), *find_cost_model("cortex-m0"), {});
}

std::vector<std::string> names(const SceneNeeds& needs) {
  std::vector<std::string> all;
  for (const Omission& omission : needs.omissions) {
    all.push_back(omission.name);
  }
  return all;
}

TEST(Needs, LeaveOutWhatTheSceneLacksAndNothingElse) {
  EXPECT_THAT(names(needs_of("closed_box")), ElementsAre("channels", "depth"));
  EXPECT_THAT(names(needs_of("parallel_plates")), ElementsAre("channels", "depth"));
  EXPECT_THAT(names(needs_of("high_rho")), ElementsAre("channels", "backs"));
  EXPECT_THAT(names(needs_of("cornell")), ElementsAre("sealed_backs"));
  EXPECT_THAT(names(needs_of("cornell_grey")), ElementsAre("channels", "sealed_backs"));
}

TEST(Needs, OfTheCornellBoxAreItsOpenFrontAndTwoBlocksWithoutBottoms) {
  const SceneNeeds needs = needs_of("cornell");
  EXPECT_EQ(needs.open_edges, 3u * 4u);
  EXPECT_EQ(needs.sealed_faces, 2u * 5u);
  EXPECT_GT(needs.buried_elements, 0u);
  EXPECT_FALSE(needs.is_convex);
  EXPECT_FALSE(needs.is_enclosed);
  EXPECT_DOUBLE_EQ(needs.lamp_watts.least, needs.lamp_watts.most) << "four equal cells of one lamp";
}

TEST(Needs, OfAFurnaceAreOneRadiosity) {
  const SceneNeeds needs = needs_of("closed_box");
  EXPECT_TRUE(needs.is_convex);
  EXPECT_TRUE(needs.is_enclosed);
  EXPECT_EQ(needs.open_edges, 0u);
  EXPECT_EQ(needs.views_without_depth, needs.views);
  EXPECT_EQ(needs.views, needs.result.eyes);
  EXPECT_NEAR(needs.radiosity.least, 2.0, 0.1);  // E / (1 - rho)
  EXPECT_NEAR(needs.radiosity.most, 2.0, 0.1);
}

// A grey scene's flux takes a third: 4 bytes received and a 16-bit account an element and channel.
TEST(Needs, OfAGreySceneSaveTheFluxOfTwoChannels) {
  const SceneNeeds needs = needs_of("cornell_grey");
  const std::uint32_t n = needs.result.plan.sizes.elements;
  EXPECT_EQ(needs.omissions[0].ram, 2 * (4 * n + 4 * ((n + 1) / 2)));
}

TEST(Needs, SaveAPartOfTheInstructionsAndNeverMoreThanAllOfThem) {
  for (const char* scene : {"cornell_grey", "high_rho", "closed_box"}) {
    const SceneNeeds needs = needs_of(scene);
    ASSERT_TRUE(needs.cost.has_value());
    for (const Omission& omission : needs.omissions) {
      ASSERT_TRUE(omission.cost.has_value());
      EXPECT_GT(*omission.cost, 0.0) << scene << ' ' << omission.name;
      EXPECT_LT(*omission.cost, *needs.cost) << scene << ' ' << omission.name;
    }
  }
}

TEST(Needs, AreToldWithoutInstructionsWhereNoCoreHasBeenMeasured) {
  BakeOptions options = on_profile("small");
  options.engine = "rays";
  const SceneNeeds needs =
      find_needs(sample("closed_box")->prepared, options, *find_cost_model("cortex-m0"), {});
  EXPECT_FALSE(needs.cost.has_value());
  EXPECT_THAT(names(needs), ElementsAre("channels"));
  EXPECT_GT(needs.omissions[0].ram, 0u);
  EXPECT_FALSE(needs.omissions[0].cost.has_value());
}

// A solver whose error is a function of the number of elements.
template <class Error>
ElementNeed search(double max_error, const Error& error) {
  const std::unique_ptr<Sample> scene = sample("cornell_grey");
  return find_elements(scene->prepared, max_error, BakeOptions{}, [&](const BakeOptions& options) {
    SweepPoint point;
    point.options = options;
    point.elements = make_plan(scene->prepared, options).sizes.elements;
    point.mean_error = error(point.elements);
    return point;
  });
}

TEST(ElementSearch, FindsTheFewestOfItsMeshesThatKeepToTheError) {
  const ElementNeed need = search(0.02, [](double n) { return 2 / n; });
  ASSERT_TRUE(need.enough && need.too_few);
  EXPECT_GE(need.enough->elements, 100u);
  EXPECT_LT(need.too_few->elements, 100u);
  EXPECT_LE(need.enough->elements, 1.5 * need.too_few->elements);
  EXPECT_EQ(need.enough->options.profile, "tiny");
}

TEST(ElementSearch, DoesNotTrustOneLuckyMesh) {
  const ElementNeed need = search(0.02, [](double n) { return n < 40 ? 0.001 : 2 / n; });
  ASSERT_TRUE(need.enough.has_value());
  EXPECT_GE(need.enough->elements, 20u);
  const ElementNeed lucky = search(0.02, [](double n) { return n < 22 ? 0.001 : 2 / n; });
  ASSERT_TRUE(lucky.enough.has_value());
  EXPECT_GE(lucky.enough->elements, 100u);
}

TEST(ElementSearch, GoesOnInALargerProfileWhereTheMemoryIsFull) {
  const ElementNeed need = search(0.002, [](double n) { return 2 / n; });
  ASSERT_TRUE(need.enough.has_value());
  EXPECT_EQ(need.enough->options.profile, "medium");
  EXPECT_GE(need.enough->elements, 1000u);
}

TEST(ElementSearch, NamesTheClosestWhereNothingKeepsToTheError) {
  const ElementNeed need = search(1e-9, [](double n) { return 1 + 1 / n; });
  EXPECT_FALSE(need.enough.has_value());
  ASSERT_TRUE(need.closest.has_value());
  EXPECT_GT(need.closest->elements, 3000u);
}

}  // namespace
}  // namespace fixrad::host::testing

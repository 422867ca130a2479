// SPDX-License-Identifier: MIT
#include "host_sim/sweep/tune.h"

#include <gmock/gmock.h>

#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

// A fine solution in the place of the truth: the search does not ask how it was found.
Truth fine_truth(const Sample& scene) {
  BakeOptions options = on_profile("medium");
  options.resolution = 64;
  const BakeResult result = bake(scene.prepared, options);
  Truth truth;
  truth.means = face_means(scene.model, result.device.overlaps, result.element_radiosity);
  truth.areas = face_areas(scene.model);
  for (const Face& face : scene.model.faces) {
    truth.emits.push_back(scene.model.materials[face.material].emission != glm::dvec3(0.0));
  }
  return truth;
}

class Tuning : public ::testing::Test {
 protected:
  Tuned run(const Wish& wish) {
    return tune(scene_->prepared, wish, BakeOptions{}, [&](const BakeOptions& options) {
      solved_.push_back(solve_setting(scene_->prepared, truth_, options, {}));
      return solved_.back();
    });
  }

  Wish wish(std::uint32_t ram, double max_error) const { return {model_, ram, max_error, {}, {}}; }

  const CostModel* model_ = find_cost_model("cortex-m0");
  std::unique_ptr<Sample> scene_ = sample("cornell_grey");
  Truth truth_ = fine_truth(*scene_);
  std::vector<SweepPoint> solved_;
};

TEST_F(Tuning, FindsTheCheapestOfAllItSolvedThatKeepToTheWish) {
  const Tuned tuned = run(wish(5500, 0.03));
  ASSERT_TRUE(tuned.cheapest.has_value());
  EXPECT_LE(ram_on(*model_, *tuned.cheapest), 5500u);
  EXPECT_LE(tuned.cheapest->mean_error, 0.03);
  for (const SweepPoint& point : solved_) {
    if (ram_on(*model_, point) <= 5500 && point.mean_error <= 0.03) {
      EXPECT_GE(cost_on(*model_, point), cost_on(*model_, *tuned.cheapest)) << point.command;
    }
  }
}

TEST_F(Tuning, BoundsTheWorstFaceTooIfAsked) {
  Wish strict = wish(5500, 0.03);
  strict.max_worst = 0.3;
  const Tuned tuned = run(strict);
  ASSERT_TRUE(tuned.cheapest.has_value());
  EXPECT_LE(tuned.cheapest->worst_error, 0.3);
}

TEST_F(Tuning, OutOfReachItNamesTheClosestWithinTheMemoryAndWhatWouldBeEnough) {
  const Tuned tuned = run(wish(3100, 0.01));
  EXPECT_FALSE(tuned.cheapest.has_value());
  ASSERT_TRUE(tuned.closest.has_value());
  EXPECT_LE(ram_on(*model_, *tuned.closest), 3100u);
  EXPECT_GT(tuned.closest->mean_error, 0.01);
  ASSERT_TRUE(tuned.enough.has_value());
  EXPECT_GT(ram_on(*model_, *tuned.enough), 3100u);
  EXPECT_LE(tuned.enough->mean_error, 0.01);
}

TEST_F(Tuning, KeepsToABoundOnInstructions) {
  Wish thrifty = wish(6000, 0.004);
  thrifty.max_cost = 20e6;
  const Tuned tuned = run(thrifty);
  EXPECT_FALSE(tuned.cheapest.has_value());
  ASSERT_TRUE(tuned.closest.has_value());
  EXPECT_LE(*cost_on(*model_, *tuned.closest), 20e6);
  ASSERT_TRUE(tuned.enough.has_value());
  EXPECT_LE(tuned.enough->mean_error, 0.004);
}

TEST_F(Tuning, EndsWhenInterrupted) {
  const Tuned tuned = tune(scene_->prepared, wish(5500, 0.03), BakeOptions{}, [](const BakeOptions&) {
    SweepPoint point;
    point.interrupted = true;
    return point;
  });
  EXPECT_TRUE(tuned.interrupted);
  EXPECT_EQ(tuned.solved, 0u);
}

}  // namespace
}  // namespace fixrad::host::testing

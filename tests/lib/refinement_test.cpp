// SPDX-License-Identifier: MIT
#include "lib/refine/refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "host_sim/simulate/simulated_device.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

// A scene on a coarse mesh in a solver with room for more elements.
class Refining {
 public:
  Refining(const Model& scene, std::uint32_t elements, std::uint32_t room)
      : model_(scene), prepared_(prepare(model_)) {
    device_ = make_device_scene(prepared_, make_uniform(prepared_, elements, elements / 4));
    settings_ = lune_settings(32, fraction(1, 1000));
    settings_.overshoot = true;
    Sizes sizes = sizes_for(device_, 0, settings_);
    sizes.elements = room;
    solver_ = std::make_unique<SimulatedDevice>(sizes);
    EXPECT_EQ(solver_->load(device_.view(), settings_), Status::ok);
    elements_.resize(room);
    patch_elements_.resize(room);
    sights_.resize(room);
    errors_.resize(room);
    patches_.resize(device_.patches.size());
    roots_.resize(device_.elements.size());
    cuts_.resize(room);
    tables_ = {elements_.data(),
               patch_elements_.data(),
               sights_.data(),
               errors_.data(),
               patches_.data(),
               roots_.data(),
               cuts_.data(),
               static_cast<std::uint16_t>(room),
               static_cast<std::uint16_t>(patches_.size()),
               static_cast<std::uint16_t>(roots_.size()),
               static_cast<std::uint16_t>(room)};
  }

  State& state() { return solver_->state(); }
  RefinedScene& tables() { return tables_; }
  const DeviceScene& device() const { return device_; }

  void shoot_times(int shots) {
    for (int i = 0; i < shots && shoot(state()) == Status::ok; ++i) {
    }
  }
  Status begin() {
    const Status status = make_refinable(state().scene, tables_);
    return status == Status::ok ? start_refining(state(), tables_, kLunes[2]) : status;
  }
  std::int64_t imbalance() {
    std::int64_t worst = 0;
    for (int c = 0; c < state().scene.channels; ++c) {
      worst = std::max(worst, std::abs(ledger(state(), c).imbalance()));
    }
    return worst;
  }

 private:
  Model model_;
  PreparedScene prepared_;
  DeviceScene device_;
  Settings settings_;
  std::unique_ptr<SimulatedDevice> solver_;
  std::vector<Element> elements_;
  std::vector<std::uint16_t> patch_elements_, roots_;
  std::vector<Sight> sights_;
  std::vector<std::uint32_t> errors_;
  std::vector<Patch> patches_;
  std::vector<Cut> cuts_;
  RefinedScene tables_ = {};
};

std::uint64_t area_of_face(const Scene& scene, std::uint16_t face) {
  std::uint64_t sum = 0;
  for (std::uint16_t e = 0; e < scene.element_count; ++e) {
    sum += scene.elements[e].face == face ? scene.elements[e].area : 0;
  }
  return sum;
}

TEST(Refinement, KeepsTheLedgerThroughEverySplitAndToTheEnd) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    Refining run(random_closed_room(seed), 90, 200);
    run.shoot_times(40);
    ASSERT_EQ(run.begin(), Status::ok);
    int splits = 0;
    while (split_worst(run.state(), run.tables(), kLunes[2]) == Status::ok) {
      ASSERT_EQ(run.imbalance(), 0) << "seed " << seed << ", split " << splits;
      ++splits;
    }
    EXPECT_GT(splits, 80);
    EXPECT_EQ(run.state().scene.element_count, 200);
    while (shoot(run.state()) == Status::ok) {
      ASSERT_EQ(run.imbalance(), 0);
    }
    EXPECT_LE(unshot_fraction(run.state()), run.state().settings.stop);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(ledger(run.state(), c).escaped, 0);
      EXPECT_EQ(ledger(run.state(), c).back, 0);
    }
  }
}

TEST(Refinement, MaySplitAndShootInTurns) {
  Refining run(random_closed_room(4), 90, 180);
  run.shoot_times(5);
  ASSERT_EQ(run.begin(), Status::ok);
  for (int i = 0; i < 90; ++i) {
    const Status split = split_worst(run.state(), run.tables(), kLunes[2]);
    ASSERT_TRUE(split == Status::ok || split == Status::too_many_elements || split == Status::converged);
    ASSERT_EQ(run.imbalance(), 0) << i;
    run.shoot_times(3);
    ASSERT_EQ(run.imbalance(), 0) << i;
  }
  run.shoot_times(100000);
  EXPECT_LE(unshot_fraction(run.state()), run.state().settings.stop);
}

TEST(Refinement, LeavesASceneThatLoadWouldAcceptWithTheSameAreas) {
  Refining run(random_closed_room(7), 90, 190);
  const Scene before = run.device().view();
  run.shoot_times(30);
  ASSERT_EQ(run.begin(), Status::ok);
  while (split_worst(run.state(), run.tables(), kLunes[2]) == Status::ok) {
  }
  const Scene& scene = run.state().scene;
  EXPECT_EQ(check_scene(scene, {1000, 1000, 1000, 3}), Status::ok);
  for (std::uint16_t f = 0; f < scene.face_count; ++f) {
    EXPECT_EQ(area_of_face(scene, f), area_of_face(before, f)) << "face " << f;
  }
}

TEST(Refinement, StopsWhenItsRoomIsFullAndSaysSo) {
  Refining run(random_closed_room(2), 90, 95);
  const std::uint16_t before = run.state().scene.element_count;
  run.shoot_times(30);
  ASSERT_EQ(run.begin(), Status::ok);
  for (std::uint16_t e = before; e < 95; ++e) {
    EXPECT_EQ(split_worst(run.state(), run.tables(), kLunes[2]), Status::ok);
  }
  EXPECT_EQ(split_worst(run.state(), run.tables(), kLunes[2]), Status::too_many_elements);
  EXPECT_EQ(run.state().scene.element_count, 95);
}

TEST(Refinement, RefusesTablesThatAreTooSmallAndChangesNothing) {
  Refining run(random_closed_room(2), 90, 95);
  run.tables().cell_capacity = 3;
  const Element* elements = run.state().scene.elements;
  EXPECT_EQ(run.begin(), Status::too_many_elements);
  EXPECT_EQ(run.state().scene.elements, elements);
}

// What they still have to send is not to be divided.
TEST(Refinement, LeavesEmittersWhole) {
  Refining run(cube(0.5, {1, 1, 1, 1, 1, 1}), 54, 120);
  ASSERT_EQ(run.begin(), Status::ok);
  EXPECT_EQ(split_worst(run.state(), run.tables(), kLunes[2]), Status::converged);
}

TEST(Refinement, SplitsTheWorstFirst) {
  Refining run(cornell(), 120, 200);
  run.shoot_times(60);
  ASSERT_EQ(run.begin(), Status::ok);
  std::uint32_t last = 0xffffffffu;
  int rises = 0, splits = 0;
  for (;;) {
    std::uint32_t largest = 0;
    for (std::uint16_t e = 0; e < run.state().scene.element_count; ++e) {
      largest = std::max(largest, run.tables().errors[e]);
    }
    if (split_worst(run.state(), run.tables(), kLunes[2]) != Status::ok) {
      break;
    }
    rises += largest > last ? 1 : 0;
    last = largest;
    ++splits;
  }
  EXPECT_GT(splits, 70);
  EXPECT_LT(rises, splits / 4) << "a part may turn out worse than its whole was thought to be, but seldom";
}

}  // namespace
}  // namespace fixrad::host

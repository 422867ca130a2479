// SPDX-License-Identifier: MIT
// What the twin is given to replay, and how its result is compared.
#include "host_sim/reference/twin_recorder.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "host_sim/reference/twin.h"
#include "tests/reference/twin_room.h"

namespace fixrad::host {
namespace {

TEST(Recorder, DropsEyesThatWereWithdrawn) {
  TwinRoom room;
  const std::uint16_t paint = room.add_material({0.5, 0.5, 0.5}, {1, 1, 1});
  room.add_box({0, 0, 0}, {8000, 0, 0}, {0, 8000, 0}, {0, 0, 8000}, true, 4, paint);
  const Scene scene = room.scene();
  State state = {};
  state.scene = scene;
  Recorder recorder(state);
  const Observer observer = recorder.observer();
  const EyeSample buried = {{{1, 1, 1}, 0, 0}, kRowOne, true};
  const EyeSample half = {{{2, 2, 2}, 0, 1}, kRowOne / 2, true};
  const EyeSample rest = {{{3, 3, 3}, 0, 2}, kRowOne / 2, true};
  const Flux eight = Flux::from_raw(8), ten = Flux::from_raw(10);
  const Shot shot = {patch_source(scene, 5), false, {eight, eight, eight}, {eight, ten, eight}};
  observer.on_eye(observer.context, kDelta16, buried);
  observer.on_withdraw(observer.context);
  observer.on_eye(observer.context, kDelta16, half);
  observer.on_eye(observer.context, kDelta16, rest);
  observer.on_shot(observer.context, shot);
  ASSERT_EQ(recorder.shots().size(), 1u);
  const Patch patch = scene.patches[5];
  const std::vector<std::uint16_t> elements(scene.patch_elements + patch.first_element,
                                            scene.patch_elements + patch.first_element + patch.element_count);
  EXPECT_EQ(recorder.shots()[0].elements, elements);
  EXPECT_EQ(recorder.shots()[0].more[1], 2);
  ASSERT_EQ(recorder.shots()[0].eye_count, 2u);
  EXPECT_EQ(recorder.eyes()[recorder.shots()[0].first_eye].sample.eye.position.x, 2);
}

// A twin that replays as it goes needs no more memory than a shot.
TEST(Recorder, ForgetsShotsAndKeepsTheEyesOfTheComingOne) {
  TwinRoom room;
  const std::uint16_t paint = room.add_material({0.5, 0.5, 0.5}, {1, 1, 1});
  room.add_box({0, 0, 0}, {8000, 0, 0}, {0, 8000, 0}, {0, 0, 8000}, true, 4, paint);
  const Scene scene = room.scene();
  State state = {};
  state.scene = scene;
  Recorder recorder(state);
  const Observer observer = recorder.observer();
  const Flux eight = Flux::from_raw(8);
  const Shot shot = {patch_source(scene, 5), false, {eight, eight, eight}, {eight, eight, eight}};
  observer.on_eye(observer.context, kDelta16, {{{1, 1, 1}, 0, 0}, kRowOne, true});
  observer.on_shot(observer.context, shot);
  observer.on_eye(observer.context, kDelta16, {{{2, 2, 2}, 0, 1}, kRowOne, true});
  recorder.forget_shots();
  EXPECT_TRUE(recorder.shots().empty());
  observer.on_shot(observer.context, shot);
  ASSERT_EQ(recorder.shots().size(), 1u);
  ASSERT_EQ(recorder.shots()[0].eye_count, 1u);
  EXPECT_EQ(recorder.eyes()[recorder.shots()[0].first_eye].sample.eye.position.x, 2);
}

TEST(CompareArithmetic, WeighsTheMeanByAreaAndTakesTheWorstChannel) {
  // Mean light of the twin: (3 * 2 + 1 * 6) / 4 = 3. Channel 1 differs by 0.3 on the small element only.
  const std::vector<glm::dvec3> twin = {{2, 2, 0}, {6, 6, 0}};
  const std::vector<glm::dvec3> fixed = {{2, 2, 0}, {6, 6.3, 0}};
  const ArithmeticError error = compare_arithmetic(fixed, twin, {3.0, 1.0});
  EXPECT_NEAR(error.mean, 0.3 / 12, 1e-12);
  EXPECT_NEAR(error.max, 0.1, 1e-12);
}

TEST(CompareArithmetic, RefusesListsOfDifferentLength) {
  EXPECT_THROW(compare_arithmetic({glm::dvec3(1)}, {glm::dvec3(1)}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fixrad::host

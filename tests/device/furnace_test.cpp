// SPDX-License-Identifier: MIT
// A closed enclosure of one reflectance that emits E everywhere has B = E / (1 - reflectance) everywhere.
#include "tests/device/box_scene.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

#define FIXRAD_SIX(...) \
  { __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__ }

constexpr FIXRAD_IN_FLASH Material kHalf[6] = FIXRAD_SIX({{0x80000000, 0, 0}, {kEmission, 0, 0}});
constexpr FIXRAD_IN_FLASH Material kNineTenths[6] = FIXRAD_SIX({{0xe6666666, 0, 0}, {kEmission, 0, 0}});

// One eye a face does not see the far elements of its neighbours as the whole face would: the means over
// faces are what one eye gets right, by symmetry. `expected` is kEmitted / (1 - reflectance).
void expect_face_means(const State& state, uint32_t expected) {
  constexpr uint32_t kPermille = 5;
  for (uint8_t f = 0; f < 6; ++f) {
    uint32_t sum = 0;
    for (uint8_t i = 0; i < kElementsPerFace; ++i) {
      const uint16_t element = static_cast<uint16_t>(f * kElementsPerFace + i);
      sum += element_radiosity(state, element, 0, Radiosity::from_raw(0)).raw;
    }
    const uint32_t mean = sum / kElementsPerFace;
    EXPECT_GT(mean, expected - expected / 1000 * kPermille);
    EXPECT_LT(mean, expected + expected / 1000 * kPermille);
  }
}

TEST(Furnace, OfReflectanceOneHalfDoublesTheEmission) {
  BoxSolver& solver = box_solver();
  ASSERT_EQ(solver.load(box_scene(kHalf), box_settings()), Status::ok);
  ASSERT_EQ(run(solver), Status::converged);
  expect_face_means(solver.state(), 2 * static_cast<uint32_t>(kEmitted));
}

TEST(Furnace, OfReflectanceNineTenthsMultipliesTheEmissionByTen) {
  BoxSolver& solver = box_solver();
  Settings settings = box_settings();
  settings.tables = &kDelta8;
  ASSERT_EQ(solver.load(box_scene(kNineTenths), settings), Status::ok);
  ASSERT_EQ(run(solver), Status::converged);
  expect_face_means(solver.state(), 10 * static_cast<uint32_t>(kEmitted));
}

// The ambient term knows the closed form before the first shot: everything is unshot.
TEST(Furnace, TheAmbientEstimateIsExactBeforeTheFirstShot) {
  BoxSolver& solver = box_solver();
  ASSERT_EQ(solver.load(box_scene(kHalf), box_settings()), Status::ok);
  EXPECT_NEAR(static_cast<int32_t>(ambient_radiosity(solver.state(), 0).raw), 2 * kEmitted, 1);
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

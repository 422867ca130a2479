// SPDX-License-Identifier: MIT
// Eyes in a box: frames, rows and form factors.
#include "tests/device/box_scene.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

constexpr FIXRAD_IN_FLASH Material kGrey[6] = {
    {{0x80000000, 0, 0}, {kEmission, 0, 0}}, {{0x80000000, 0, 0}, {kEmission, 0, 0}},
    {{0x80000000, 0, 0}, {kEmission, 0, 0}}, {{0x80000000, 0, 0}, {kEmission, 0, 0}},
    {{0x80000000, 0, 0}, {kEmission, 0, 0}}, {{0x80000000, 0, 0}, {kEmission, 0, 0}}};

// A component is rounded twice, each time by half a unit; a sum of three products of two such vectors of
// length 2^14 is then off by less than 2 sqrt(3) 2^14.
constexpr int32_t kFrameTolerance = 56756;

void expect_orthonormal(const Face& face) {
  for (uint8_t turn = 0; turn < kTurns; ++turn) {
    const EyeFrame frame = eye_frame(face, turn);
    ASSERT_NEAR(dot(frame.x, frame.x), kUnit * kUnit, kFrameTolerance);
    ASSERT_NEAR(dot(frame.y, frame.y), kUnit * kUnit, kFrameTolerance);
    ASSERT_NEAR(dot(frame.x, frame.y), 0, kFrameTolerance);
    ASSERT_NEAR(dot(frame.x, frame.z), 0, kFrameTolerance);
    ASSERT_NEAR(dot(frame.y, frame.z), 0, kFrameTolerance);
    const Vec3 z = cross(frame.x, frame.y);
    ASSERT_GT(dot(scale_down(z, 14), frame.z), kUnit * kUnit - 2 * kFrameTolerance);
  }
}

TEST(EyeFrame, IsOrthonormalAndRightHandedAtEveryTurn) {
  const Scene scene = box_scene(kGrey);
  for (uint8_t f = 0; f < 6; ++f) {
    expect_orthonormal(flash_read(scene.faces, f));
  }
}

TEST(EyeFrame, IsOrthonormalOnATiltedFace) {
  Face face = {};
  const int16_t normal[3] = {10923, 10923, 5461};  // (2, 2, 1) / 3
  const int16_t tangent[3] = {11585, -11585, 0};   // (1, -1, 0) / sqrt(2)
  for (uint8_t i = 0; i < 3; ++i) {
    face.normal[i] = normal[i];
    face.tangent[i] = tangent[i];
  }
  expect_orthonormal(face);
}

// Looks with the whole row as the eye's weight; returns what the elements get.
uint32_t look(State& state, const EyePoint& eye, bool back_faces) {
  const Settings& settings = state.settings;
  clear(state.row);
  const DeltaTable table = flash_read(settings.tables, settings.table_count - 1u);
  EXPECT_EQ(settings.engine(state.scene, table, {eye, kRowOne, back_faces}, state.work, state.row),
            Status::ok);
  uint32_t sum = 0;
  for (uint16_t e = 0; e < state.row.count; ++e) {
    sum += state.row.share[e];
  }
  return sum;
}

uint32_t share_of_face(const State& state, uint8_t face) {
  uint32_t sum = 0;
  for (uint8_t e = 0; e < kElementsPerFace; ++e) {
    sum += state.row.share[face * kElementsPerFace + e];
  }
  return sum;
}

EyePoint element_eye(const Scene& scene, uint16_t element, uint8_t turn) {
  const Element record = flash_read(scene.elements, element);
  return {vec(record.eye), record.face, turn};
}

Settings lune_settings() {
  Settings settings = box_settings();
  settings.engine = lune_rows;
  settings.tables = settings.probe = kLunes;
  settings.table_count = kLuneTables;
  return settings;
}

void expect_complete_rows(const Settings& settings) {
  State& state = box_solver().state();
  ASSERT_EQ(box_solver().load(box_scene(kGrey), settings), Status::ok);
  for (uint16_t e = 0; e < state.scene.element_count; ++e) {
    ASSERT_EQ(look(state, element_eye(state.scene, e, static_cast<uint8_t>(e % kTurns)), false), kRowOne);
    ASSERT_EQ(state.row.escaped + state.row.back, 0u);
  }
}

TEST(Rows, OfAClosedBoxSumToOneForTheEyeOfEveryElement) {
  expect_complete_rows(box_settings());
}

TEST(Lunes, OfAClosedBoxSumToOneForTheEyeOfEveryElement) {
  expect_complete_rows(lune_settings());
}

TEST(Pixels, OfAClosedBoxSumToOneForTheEyeOfEveryElement) {
  Settings settings = box_settings();
  settings.engine = hemicube_pixels;
  settings.tables = &kDelta8;
  expect_complete_rows(settings);
}

TEST(Rows, OfABoxWithoutAFaceLoseWhatThatFaceWouldGet) {
  State& state = box_solver().state();
  ASSERT_EQ(box_solver().load(box_scene(kGrey), box_settings()), Status::ok);
  const EyePoint eye = element_eye(state.scene, 0, 3);
  look(state, eye, false);
  const int32_t behind = static_cast<int32_t>(share_of_face(state, 5));
  ASSERT_EQ(box_solver().load(box_scene(kGrey, 5), box_settings()), Status::ok);
  EXPECT_EQ(look(state, eye, true) + state.row.escaped, kRowOne);
  EXPECT_NEAR(static_cast<int32_t>(state.row.escaped), behind, 8);
}

// From the middle of a unit square to the parallel one at unit distance:
// F = 4/pi (0.5/sqrt(1.25)) atan(0.5/sqrt(1.25)) = 0.239456 (Howell, "A Catalog of Radiation Heat Transfer
// Configuration Factors", B-4, four quarters); the four walls share the rest. Tolerance: UQ1.20.
void expect_closed_form(const Settings& settings, int32_t tolerance) {
  constexpr int32_t kOpposite = 251088;  // 0.239456 * 2^20
  constexpr int32_t kWall = (1048576 - kOpposite) / 4;
  State& state = box_solver().state();
  ASSERT_EQ(box_solver().load(box_scene(kGrey), settings), Status::ok);
  for (uint8_t turn = 0; turn < kTurns; ++turn) {
    look(state, {{2, 16384, 16384}, 0, turn}, false);  // quarters of a grid unit
    EXPECT_NEAR(static_cast<int32_t>(share_of_face(state, 1)), kOpposite, tolerance);
    for (uint8_t f = 2; f < 6; ++f) {
      EXPECT_NEAR(static_cast<int32_t>(share_of_face(state, f)), kWall, tolerance);
    }
    EXPECT_EQ(share_of_face(state, 0), 0u);
  }
}

TEST(Rows, ReachTheClosedFormFromTheMiddleOfAFace) {
  expect_closed_form(box_settings(), static_cast<int32_t>(kRowOne / 400));
}

// A border along a lune may be off by half of one, and a face has two.
TEST(Lunes, ReachTheClosedFormFromTheMiddleOfAFace) {
  expect_closed_form(lune_settings(), static_cast<int32_t>(kRowOne / 128));
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

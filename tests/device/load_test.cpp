// SPDX-License-Identifier: MIT
#include "tests/device/box_scene.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

#define FIXRAD_FIVE(...) __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__

constexpr FIXRAD_IN_FLASH Material kGood[6] = {{{0, 0, 0}, {kEmission, 0, 0}},
                                               FIXRAD_FIVE({{0x80000000, 0, 0}, {0, 0, 0}})};
constexpr FIXRAD_IN_FLASH Material kDark[6] = {{{0, 0, 0}, {0, 0, 0}},
                                               FIXRAD_FIVE({{0x80000000, 0, 0}, {0, 0, 0}})};
constexpr FIXRAD_IN_FLASH Material kMirror[6] = {{{0xffffffff, 0, 0}, {kEmission, 0, 0}},
                                                 FIXRAD_FIVE({{0x80000000, 0, 0}, {0, 0, 0}})};
constexpr FIXRAD_IN_FLASH Material kDazzling[6] = {{{0, 0, 0}, {0xffffffff, 0, 0}},
                                                   FIXRAD_FIVE({{0x80000000, 0, 0}, {0, 0, 0}})};

constexpr FIXRAD_IN_FLASH Vertex kOffGrid[8] = {{-1, 0, 0},      {8192, 0, 0},      {0, 8192, 0},
                                                {8192, 8192, 0}, {0, 0, 8192},      {8192, 0, 8192},
                                                {0, 8192, 8192}, {8192, 8192, 8192}};
constexpr FIXRAD_IN_FLASH Vertex kBent[8] = {{90, 0, 0},      {8192, 0, 0},      {0, 8192, 0},
                                             {8192, 8192, 0}, {0, 0, 8192},      {8192, 0, 8192},
                                             {0, 8192, 8192}, {8192, 8192, 8192}};
constexpr FIXRAD_IN_FLASH uint16_t kRepeated[24] = {0, 0, 6, 4, 1, 5, 7, 3, 0, 4, 5, 1,
                                                    2, 3, 7, 6, 0, 1, 3, 2, 4, 6, 7, 5};
constexpr FIXRAD_IN_FLASH uint16_t kOutside[24] = {0, 2, 6, 8, 1, 5, 7, 3, 0, 4, 5, 1,
                                                   2, 3, 7, 6, 0, 1, 3, 2, 4, 6, 7, 5};
constexpr FIXRAD_IN_FLASH uint16_t kCrossed[24] = {0, 6, 2, 4, 1, 5, 7, 3, 0, 4, 5, 1,
                                                   2, 3, 7, 6, 0, 1, 3, 2, 4, 6, 7, 5};
constexpr FIXRAD_IN_FLASH uint16_t kSwapped[24] = {0,  1,  2,  4,  3,  5,  6,  7,  8,  9,  10, 11,
                                                   12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23};

using Change = void (*)(Scene&);
struct Refusal {
  Change change;
  Status status;
};

const Refusal kRefusals[] = {
    {[](Scene& s) { s.channels = 0; }, Status::bad_channel_count},
    {[](Scene& s) { s.channels = 4; }, Status::bad_channel_count},
    {[](Scene& s) { s.vertex_count = 9; }, Status::too_many_vertices},
    {[](Scene& s) { s.face_count = 7; }, Status::too_many_faces},
    {[](Scene& s) { s.element_count = 25; }, Status::too_many_elements},
    {[](Scene& s) { s.patch_count = 7; }, Status::bad_index},
    {[](Scene& s) { s.emission_shift = 64; }, Status::bad_unit},
    {[](Scene& s) { s.vertices = kOffGrid; }, Status::vertex_off_grid},
    {[](Scene& s) { s.vertices = kBent; }, Status::not_planar},
    {[](Scene& s) { s.corners = kOutside; }, Status::bad_index},
    {[](Scene& s) { s.corners = kRepeated; }, Status::repeated_corner},
    {[](Scene& s) { s.corners = kCrossed; }, Status::not_convex},
    {[](Scene& s) { s.patch_elements = kSwapped; }, Status::bad_index},
    {[](Scene& s) { s.material_count = 5; }, Status::bad_index},
    {[](Scene& s) { s.cell_row_count = 11; }, Status::bad_index},
    {[](Scene& s) { s.materials = kDark; }, Status::no_emitter},
    {[](Scene& s) { s.materials = kMirror; }, Status::reflectance_not_below_one},
    {[](Scene& s) {
       s.materials = kDazzling;
       s.emission_shift = 31;
     },
     Status::flux_overflow},
};

uint64_t digest_of(const BoxSolver& solver) {
  return digest(solver.state(), {nullptr, nullptr, 0});
}

TEST(Load, RefusesBadTablesWithTheirReason) {
  for (const Refusal& refusal : kRefusals) {
    Scene scene = box_scene(kGood);
    refusal.change(scene);
    EXPECT_EQ(box_solver().load(scene, box_settings()), refusal.status);
  }
}

TEST(Load, LeavesTheSolutionAsItWasWhenItRefuses) {
  BoxSolver& solver = box_solver();
  ASSERT_EQ(solver.load(box_scene(kGood), box_settings()), Status::ok);
  ASSERT_EQ(run(solver), Status::converged);
  const uint64_t whole = digest_of(solver);
  const uint32_t shots = solver.state().shots;
  ASSERT_GT(shots, 3u);

  ASSERT_EQ(solver.load(box_scene(kGood), box_settings()), Status::ok);
  for (Status status = Status::ok; status == Status::ok; status = solver.step()) {
    const Refusal& refusal = kRefusals[solver.state().shots % (sizeof kRefusals / sizeof kRefusals[0])];
    Scene broken = box_scene(kGood);
    refusal.change(broken);
    ASSERT_EQ(solver.load(broken, Settings()), refusal.status);
  }
  EXPECT_EQ(digest_of(solver), whole);
  EXPECT_EQ(solver.state().shots, shots);
}

TEST(Load, ForgetsTheOldSolution) {
  BoxSolver& solver = box_solver();
  ASSERT_EQ(solver.load(box_scene(kGood), box_settings()), Status::ok);
  const uint64_t empty = digest_of(solver);
  ASSERT_EQ(run(solver), Status::converged);
  ASSERT_NE(digest_of(solver), empty);
  ASSERT_EQ(solver.load(box_scene(kGood), box_settings()), Status::ok);
  EXPECT_EQ(digest_of(solver), empty);
  EXPECT_EQ(solver.state().shots, 0u);
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad

// SPDX-License-Identifier: MIT
// One mutated record for each Status.
#include "lib/scene/load.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>

#include "lib/fixrad.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr Capacity kRoomy = {100, 100, 1000, 3};

DeviceScene valid_scene() {
  const Model model = cube(0.5, {0, 0, 0, 1, 0, 0});
  const PreparedScene prepared = prepare(model);
  return make_device_scene(prepared, make_uniform(prepared, 54, 30));
}

using Mutation = std::function<void(DeviceScene&)>;

Status status_after(const Mutation& mutate) {
  DeviceScene scene = valid_scene();
  mutate(scene);
  return check_scene(scene.view(), kRoomy);
}

TEST(CheckScene, AcceptsAValidScene) {
  EXPECT_EQ(status_after([](DeviceScene&) {}), Status::ok);
}

TEST(CheckScene, RefusesMoreThanTheStorageHolds) {
  const DeviceScene scene = valid_scene();
  Capacity capacity = kRoomy;
  capacity.vertices = 7;
  EXPECT_EQ(check_scene(scene.view(), capacity), Status::too_many_vertices);
  capacity = kRoomy;
  capacity.faces = 5;
  EXPECT_EQ(check_scene(scene.view(), capacity), Status::too_many_faces);
  capacity = kRoomy;
  capacity.elements = static_cast<std::uint16_t>(scene.elements.size() - 1);
  EXPECT_EQ(check_scene(scene.view(), capacity), Status::too_many_elements);
  capacity = {8, 6, static_cast<std::uint16_t>(scene.elements.size()), 1};
  EXPECT_EQ(check_scene(scene.view(), capacity), Status::ok) << "exactly full is no fault";
}

TEST(CheckScene, RefusesChannelCounts) {
  EXPECT_EQ(status_after([](DeviceScene& s) { s.channels = 0; }), Status::bad_channel_count);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.channels = 2; }), Status::bad_channel_count);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.channels = 4; }), Status::bad_channel_count);
  DeviceScene rgb = valid_scene();
  rgb.channels = 3;
  EXPECT_EQ(check_scene(rgb.view(), {100, 100, 1000, 1}), Status::bad_channel_count);
}

TEST(CheckScene, RefusesRecordsThatPointOutside) {
  const std::vector<Mutation> mutations = {
      [](DeviceScene& s) { s.corners[5] = 8; },
      [](DeviceScene& s) { s.faces[1].first_corner = 21; },
      [](DeviceScene& s) { s.faces[1].corner_count = 2; },
      [](DeviceScene& s) { s.faces[1].corner_count = kMaxCorners + 1; },
      [](DeviceScene& s) { s.faces[1].material = 6; },
      [](DeviceScene& s) { s.faces[5].first_cell_row = static_cast<std::uint16_t>(s.cell_rows.size()); },
      [](DeviceScene& s) {
        s.cell_rows.back().first_element = static_cast<std::uint16_t>(s.elements.size());
      },
      [](DeviceScene& s) { s.elements[3].material = static_cast<std::uint16_t>(s.elements[3].material + 1); },
      [](DeviceScene& s) { s.elements[3].patch = static_cast<std::uint16_t>(s.patches.size()); },
      [](DeviceScene& s) { s.patches[2].element_count = 0; },
      [](DeviceScene& s) { ++s.patches[2].first_element; },
      [](DeviceScene& s) { s.patch_elements[4] = static_cast<std::uint16_t>(s.elements.size()); },
      [](DeviceScene& s) { std::swap(s.patch_elements.front(), s.patch_elements.back()); },
  };
  for (std::size_t i = 0; i < mutations.size(); ++i) {
    EXPECT_EQ(status_after(mutations[i]), Status::bad_index) << "mutation " << i;
  }
}

// A face shoots as the elements that follow each other. Two faces of one element each change places.
TEST(CheckScene, RefusesElementsThatAreNotOrderedByFace) {
  const Model model = cube(0.5, {0, 0, 0, 1, 0, 0});
  const PreparedScene prepared = prepare(model);
  DeviceScene scene = make_device_scene(prepared, make_uniform(prepared, 6, 6));
  ASSERT_EQ(scene.elements.size(), 6u);
  ASSERT_EQ(check_scene(scene.view(), kRoomy), Status::ok);
  std::swap(scene.elements[1], scene.elements[2]);
  std::swap(scene.cell_rows[1].first_element, scene.cell_rows[2].first_element);
  std::swap(scene.patch_elements[1], scene.patch_elements[2]);
  EXPECT_EQ(check_scene(scene.view(), kRoomy), Status::bad_index);
}

TEST(CheckScene, RefusesElementGrids) {
  EXPECT_EQ(status_after([](DeviceScene& s) { s.faces[2].cells_u = 0; }), Status::bad_grid);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.faces[2].cells_v = 128; }), Status::bad_grid);
  EXPECT_EQ(status_after([](DeviceScene& s) { std::swap(s.faces[2].axis_u, s.faces[2].axis_v); }),
            Status::bad_grid);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.cell_rows[0].last_cell = 99; }), Status::bad_grid);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.cell_rows[0].first_element = 20; }), Status::bad_grid);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.elements[3].face = 6; }), Status::bad_grid)
      << "its row disagrees";
}

TEST(CheckScene, RefusesVerticesOffTheGrid) {
  EXPECT_EQ(status_after([](DeviceScene& s) { s.vertices[3].x = -1; }), Status::vertex_off_grid);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.vertices[3].y = kGridMax + 1; }), Status::vertex_off_grid);
}

TEST(CheckScene, RefusesFacesThatAreNoConvexPolygons) {
  EXPECT_EQ(status_after([](DeviceScene& s) { s.corners[1] = s.corners[0]; }), Status::repeated_corner);
  EXPECT_EQ(status_after([](DeviceScene& s) { std::swap(s.corners[1], s.corners[2]); }), Status::not_convex);
  EXPECT_EQ(status_after([](DeviceScene& s) { std::swap(s.corners[1], s.corners[3]); }), Status::not_convex);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.faces[0].normal[0] = 100; }), Status::not_planar);
}

TEST(CheckScene, AcceptsOnlyWhatRoundingCanMoveACornerOffItsPlane) {
  const auto moved_by = [](int units) {
    return status_after([units](DeviceScene& s) {
      Vertex& corner = s.vertices[s.corners[2]];  // face 0 is the wall at -x
      corner.x = static_cast<std::int16_t>(corner.x + units);
    });
  };
  EXPECT_EQ(moved_by(1), Status::ok);
  EXPECT_EQ(moved_by(kPlaneTolerance + 1), Status::not_planar);
}

TEST(CheckScene, RefusesZeroArea) {
  EXPECT_EQ(status_after([](DeviceScene& s) { s.elements[7].area = 0; }), Status::zero_area);
  EXPECT_EQ(status_after([](DeviceScene& s) {
              for (int k = 1; k < 4; ++k) {  // four vertices in one place
                Vertex& v = s.vertices[s.corners[static_cast<std::size_t>(k)]];
                v = s.vertices[s.corners[0]];
              }
            }),
            Status::zero_area);
}

TEST(CheckScene, RefusesEyesThatAreNotJustAboveTheirFace) {
  const auto with_eye_at = [](std::uint16_t x) {
    return status_after([x](DeviceScene& s) { s.elements[0].eye[0] = x; });
  };
  const auto plane =
      static_cast<std::uint16_t>(kEyeScale * valid_scene().vertices[valid_scene().corners[0]].x);
  EXPECT_EQ(with_eye_at(plane), Status::bad_eye);
  EXPECT_EQ(with_eye_at(static_cast<std::uint16_t>(plane + 1)), Status::ok);
  EXPECT_EQ(with_eye_at(static_cast<std::uint16_t>(plane + kEyeScale * (kPlaneTolerance + 2))),
            Status::bad_eye);
}

TEST(CheckScene, RefusesLightThatCannotBeCounted) {
  EXPECT_EQ(status_after([](DeviceScene& s) { s.materials[0].reflectance[0] = 0xffffffffu; }),
            Status::reflectance_not_below_one);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.materials[3].emission[0] = 0; }), Status::no_emitter);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.emission_shift = 0; }), Status::flux_overflow);
  EXPECT_EQ(status_after([](DeviceScene& s) { s.emission_shift -= 1; }), Status::flux_overflow)
      << "the unit leaves no second bit";
  EXPECT_EQ(status_after([](DeviceScene& s) { s.materials[0].reflectance[0] = 0xf0000000u; }),
            Status::flux_overflow);
}

TEST(Load, LeavesTheSolutionAsItWasWhenItFails) {
  SolveOptions options;
  options.elements = 54;
  options.settings = settings_with(8, fraction(1, 100));
  Solution whole(cube(0.5, {0, 0, 0, 1, 0, 0}), options);
  whole.run();
  const DeviceScene& scene = whole.device();
  using Small = Limits<8, 6, 54, 13, 1>;
  const auto solver = std::make_unique<Solver<Small>>();
  ASSERT_EQ(solver->load(scene.view(), options.settings), Status::ok);
  Status status = Status::ok;
  while (status == Status::ok) {
    DeviceScene broken = scene;
    broken.corners[1] = broken.corners[0];
    ASSERT_EQ(solver->load(broken.view()), Status::repeated_corner);
    status = solver->step();
  }
  const SurfaceMesh mesh = make_surface_mesh(whole.prepared(), scene);
  EXPECT_EQ(digest(solver->state(), mesh.map()), whole.digest());
}

}  // namespace
}  // namespace fixrad::host

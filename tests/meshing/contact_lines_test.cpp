// SPDX-License-Identifier: MIT
#include "host_sim/meshing/contact_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "host_sim/io/obj_reader.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

Model sample(const std::string& name) {
  return read_obj(std::string(FIXRAD_SOURCE_DIR) + "/scenes/" + name + ".obj");
}

DeviceScene cut_scene(const PreparedScene& scene, std::uint32_t elements) {
  Meshing meshing = make_uniform(scene, elements, elements);
  cut_at_contacts(scene, meshing);
  DeviceScene device = make_device_scene(scene, meshing);
  EXPECT_EQ(device.elements.size(), meshing.element_count);
  return device;
}

/// Lets a block, of which only the side at x = 4 is modelled, stand across the floor [0, 10]^2.
Model floor_with_a_screen() {
  Model model;
  model.materials.push_back({"grey", glm::dvec3{0.5}, glm::dvec3{0.0}});
  model.positions = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0},
                     {4, 3, 0}, {4, 7, 0},  {4, 7, 5},   {4, 3, 5}};
  model.faces.resize(2);
  model.faces[0].corners = {0, 1, 2, 3};
  model.faces[1].corners = {4, 5, 6, 7};
  model.file_faces = 2;
  return model;
}

TEST(ContactCuts, AScreenCutsTheFloorWhereItStands) {
  const Model model = floor_with_a_screen();
  const PreparedScene scene = prepare(model);
  const DeviceScene cut = cut_scene(scene, 2);
  ASSERT_EQ(cut.mesh.elements.size(), 3U);
  EXPECT_NEAR(cut.mesh.elements[0].area + cut.mesh.elements[1].area, 100.0, 0.1);
  const double smaller = std::min(cut.mesh.elements[0].area, cut.mesh.elements[1].area);
  EXPECT_NEAR(smaller, 40.0, 0.1);
  EXPECT_NEAR(cut.mesh.elements[2].area, 20.0, 0.1);
}

TEST(ContactCuts, LeaveElementsAwayFromTheContactAlone) {
  const Model model = floor_with_a_screen();
  const PreparedScene scene = prepare(model);
  constexpr std::uint32_t kElements = 110;
  const DeviceScene device = make_device_scene(scene, make_uniform(scene, kElements, kElements));
  const DeviceScene cut = cut_scene(scene, kElements);
  // The screen is 4 long and crosses a row of elements about 1 wide.
  EXPECT_GT(cut.mesh.elements.size(), device.mesh.elements.size());
  EXPECT_LE(cut.mesh.elements.size(), device.mesh.elements.size() + 7);
}

TEST(ContactCuts, KeepAreasAndOverlapsOfEachFace) {
  for (const char* name : {"cornell", "furnished_room", "portico"}) {
    const Model model = sample(name);
    const PreparedScene scene = prepare(model);
    constexpr std::uint32_t kElements = 600;
    const DeviceScene device = make_device_scene(scene, make_uniform(scene, kElements, kElements));
    const DeviceScene cut = cut_scene(scene, kElements);
    std::map<std::uint32_t, double> before;
    std::map<std::uint32_t, double> after;
    std::vector<double> of_element(cut.mesh.elements.size(), 0.0);
    for (const Overlap& o : device.overlaps) {
      before[o.input_face] += o.area;
    }
    for (const Overlap& o : cut.overlaps) {
      after[o.input_face] += o.area;
      of_element[o.element] += o.area;
    }
    ASSERT_EQ(before.size(), after.size()) << name;
    for (const auto& [face, area] : before) {
      EXPECT_NEAR(after[face], area, 1e-9 * area) << name << ' ' << face;
    }
    for (std::size_t e = 0; e < of_element.size(); ++e) {
      EXPECT_GT(of_element[e], 0.0) << name << ' ' << e;
    }
  }
}

TEST(ContactLines, ABoxOnTheFloorLeavesItsFourFeetLines) {
  const Model model = room_with_box(Stand::closed_on_floor, 0.3);
  const PreparedScene scene = prepare(model);
  const std::vector<ContactLine> lines = contact_lines(scene);
  ASSERT_EQ(lines.size(), 4u);
  for (const ContactLine& line : lines) {
    const FaceFrame& frame = scene.frames[line.face];
    EXPECT_NEAR(frame.normal.y, 1.0, 1e-9) << "on the floor";
    EXPECT_NEAR(glm::distance(frame.to_grid(line.a), frame.to_grid(line.b)) / scene.vertices.grid.scale, 1.0,
                1e-3);
  }
}

TEST(ContactLines, WhereNothingTouchesThereAreNone) {
  const Model floating = room_with_box(Stand::floating, 0.3);
  EXPECT_TRUE(contact_lines(prepare(floating)).empty());
  const Model empty = cube(0.5, {0, 0, 0, 1, 0, 0});
  EXPECT_TRUE(contact_lines(prepare(empty)).empty()) << "walls meet along borders only";
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/reference/refined_radiosity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "host_sim/io/obj_reader.h"
#include "host_sim/reference/contact_cuts.h"
#include "host_sim/reference/error_budget.h"

namespace fixrad::host {
namespace {

Model sample(const std::string& name) {
  return read_obj(std::string(FIXRAD_SOURCE_DIR) + "/scenes/" + name + ".obj");
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
  const OverlappedMesh cut = cut_at_contacts(scene, make_device_scene(scene, make_uniform(scene, 2, 2)));
  ASSERT_EQ(cut.mesh.elements.size(), 3U);
  EXPECT_NEAR(cut.mesh.elements[0].area + cut.mesh.elements[1].area, 100.0, 0.1);
  const double smaller = std::min(cut.mesh.elements[0].area, cut.mesh.elements[1].area);
  EXPECT_NEAR(smaller, 40.0, 0.1);
  EXPECT_NEAR(cut.mesh.elements[2].area, 20.0, 0.1);
}

TEST(ContactCuts, LeaveElementsAwayFromTheContactAlone) {
  const Model model = floor_with_a_screen();
  const PreparedScene scene = prepare(model);
  const DeviceScene device = make_device_scene(scene, make_uniform(scene, 110, 110));
  const OverlappedMesh cut = cut_at_contacts(scene, device);
  // The screen is 4 long and crosses a row of elements about 1 wide.
  EXPECT_GT(cut.mesh.elements.size(), device.mesh.elements.size());
  EXPECT_LE(cut.mesh.elements.size(), device.mesh.elements.size() + 7);
}

TEST(ContactCuts, KeepAreasAndOverlapsOfEachFace) {
  for (const char* name : {"cornell", "furnished_room", "portico"}) {
    const Model model = sample(name);
    const PreparedScene scene = prepare(model);
    const DeviceScene device = make_device_scene(scene, make_uniform(scene, 600, 600));
    const OverlappedMesh cut = cut_at_contacts(scene, device);
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

TEST(RefinedRadiosity, AFurnaceSettlesAtOnceAtItsClosedForm) {
  const Model model = sample("closed_box");
  const RefinedRadiosity refined = refined_radiosity(prepare(model), {0.001, 100, 400});
  EXPECT_TRUE(refined.settled);
  EXPECT_LT(refined.elements, 300U);
  for (std::size_t f = 0; f < refined.face_means.size(); ++f) {
    const Material& material = model.materials[model.faces[f].material];
    for (glm::length_t c = 0; c < 3; ++c) {
      const double expected = material.emission[c] / (1.0 - material.reflectance[c]);
      EXPECT_NEAR(refined.face_means[f][c], expected, 1e-3 * expected) << f;
    }
  }
}

TEST(RefinedRadiosity, StopsAtTheLargestMeshAndSaysThatItDidNotSettle) {
  const Model model = sample("cornell");
  const RefinedRadiosity refined = refined_radiosity(prepare(model), {0.0, 60, 240});
  EXPECT_FALSE(refined.settled);
  EXPECT_GT(refined.change, 0.0);
  EXPECT_GT(refined.elements, 180U);
  EXPECT_LT(refined.elements, 400U);
}

TEST(RefinedRadiosity, OneMeshAloneHasNotSettled) {
  const Model model = sample("cornell");
  const RefinedRadiosity refined = refined_radiosity(prepare(model), {0.001, 120, 120});
  EXPECT_FALSE(refined.settled);
  EXPECT_TRUE(std::isinf(refined.change));
}

TEST(FaceMeanErrors, NameTheWorstFaceThatIsBrightEnough) {
  const std::vector<glm::dvec3> truth{glm::dvec3{9.0}, glm::dvec3{1.0}, glm::dvec3{1.0}, glm::dvec3{0.01}};
  const std::vector<glm::dvec3> other{glm::dvec3{5.0}, glm::dvec3{1.1}, glm::dvec3{1.3}, glm::dvec3{0.1}};
  const FaceMeanError error =
      compare_face_means(other, truth, {1.0, 1.0, 1.0, 1.0}, {true, false, false, false});
  EXPECT_EQ(error.worst_face, 2U);  // the lamp and the dark face do not count
  EXPECT_NEAR(error.worst, 0.3, 1e-12);
  EXPECT_NEAR(error.mean, (0.1 + 0.3 + 0.09) / 2.01, 1e-12);
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/reference/refined_radiosity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host_sim/io/obj_reader.h"
#include "host_sim/reference/error_budget.h"

namespace fixrad::host {
namespace {

Model sample(const std::string& name) {
  return read_obj(std::string(FIXRAD_SOURCE_DIR) + "/scenes/" + name + ".obj");
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

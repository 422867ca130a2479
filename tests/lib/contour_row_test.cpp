// SPDX-License-Identifier: MIT
// Elements as polygons, and rows of form factors made of contours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lib/form_factor/cell_polygon.h"
#include "tests/lib/closed_forms.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

double area_of(const Polygon& polygon) {
  glm::dvec3 sum(0.0);
  const auto to_double = [](const Vec3& a) { return glm::dvec3(a.x, a.y, a.z) / double{kFineScale}; };
  for (int k = 1; k + 1 < polygon.count; ++k) {
    sum += glm::cross(to_double(polygon.corner[k]) - to_double(polygon.corner[0]),
                      to_double(polygon.corner[k + 1]) - to_double(polygon.corner[0]));
  }
  return glm::length(sum) / 2;
}

SolveOptions options_with(std::uint32_t elements) {
  SolveOptions options;
  options.elements = elements;
  options.settings = settings_with(16, fraction(1, 1000));
  options.settings.engine = contour_row;
  return options;
}

void expect_rows_of_one(State& state, std::uint32_t first, bool back_faces) {
  for (std::uint32_t e = first; e < state.scene.element_count; e += 7) {
    clear(state.row);
    for (const std::uint32_t weight : {kRowOne / 3, kRowOne - kRowOne / 3}) {
      const EyeSample sample = {element_eye(state.scene, e), weight, back_faces};
      ASSERT_EQ(contour_row(state.scene, *state.settings.tables, sample, state.work, state.row), Status::ok);
    }
    std::uint64_t sum = state.row.escaped + state.row.back;
    for (unsigned j = 0; j < state.scene.element_count; ++j) {
      sum += state.row.share[j];
    }
    ASSERT_EQ(sum, kRowOne) << "element " << e;
  }
}

// The area of an element's record is the host's own, cut in double: 1/8 square grid unit.
TEST(ElementPolygons, HaveTheAreaOfTheirElements) {
  for (const Model& model : {cornell(), random_closed_room(3), random_closed_room(8)}) {
    Solution solution(model, options_with(300));
    const Scene& scene = solution.state().scene;
    std::vector<int> seen(scene.element_count, 0);
    for (unsigned f = 0; f < scene.face_count; ++f) {
      const fixrad::Face face = flash_read(scene.faces, f);
      for (ElementCellWalk walk(scene, face); walk.next();) {
        Polygon polygon;
        element_polygon(scene, face, walk.cells(), polygon);
        const unsigned e = walk.cells().element;
        const double area = flash_read(scene.elements, e).area / 8.0;
        const double rounding = 0.05 * std::sqrt(area) + 1;
        EXPECT_NEAR(area_of(polygon), area, rounding + 0.002 * area) << "element " << e;
        ++seen[e];
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), scene.element_count) << "each exactly once";
  }
}

TEST(ElementPolygons, AreFoundByTheElement) {
  Solution solution(cornell(), options_with(200));
  const Scene& scene = solution.state().scene;
  for (std::uint16_t e = 0; e < scene.element_count; ++e) {
    const fixrad::Face face = flash_read(scene.faces, flash_read(scene.elements, e).face);
    EXPECT_EQ(cells_of(scene, face, e).element, e);
  }
}

TEST(ContourRow, LosesNothingInAClosedConvexRoom) {
  Solution solution(cube(0.5, {1, 0, 0, 0, 0, 0}), options_with(150));
  State& state = solution.state();
  expect_rows_of_one(state, 0, false);
  ASSERT_EQ(solution.run(), Status::converged);
  EXPECT_EQ(state.escaped[0], 0);
  EXPECT_EQ(solution.imbalance(), 0);
}

TEST(ContourRow, IsARowOfOneAlsoWhereFacesHideEachOther) {
  Solution solution(cornell(), options_with(200));
  expect_rows_of_one(solution.state(), 0, true);
}

TEST(ContourRow, CountsWhatShowsItsBackApart) {
  Model model = parallel_squares(0.5, 1, 0.5);
  std::reverse(model.faces[1].corners.begin(), model.faces[1].corners.end());
  Solution solution(model, options_with(50));
  State& state = solution.state();
  clear(state.row);
  const EyeSample sample = {element_eye(state.scene, 0), kRowOne, true};
  ASSERT_EQ(contour_row(state.scene, *state.settings.tables, sample, state.work, state.row), Status::ok);
  const glm::dvec3 eye = solution.device().mesh.elements[0].centroid;
  const double exact = point_to_parallel({-eye.x, 1 - eye.x, -eye.z, 1 - eye.z}, 1.0);
  EXPECT_NEAR(state.row.back / static_cast<double>(kRowOne), exact, 1e-4 * exact);
  EXPECT_EQ(state.row.back + state.row.escaped, kRowOne);
}

// Every eye and element of a cube against the closed form; n x n elements a face.
TEST(ContourRow, FromEveryEyeOfAFaceIsTheClosedFormOfTheOppositeFace) {
  constexpr double kBound = 2e-4;  // relative: the lift of the eyes by half a grid unit, the grid itself
  Solution solution(cube(0.5, {1, 1, 1, 1, 1, 1}), options_with(216));
  State& state = solution.state();
  for (unsigned e = 0; e < state.scene.element_count; ++e) {
    const Element element = flash_read(state.scene.elements, e);
    if (element.face != 2) {  // the floor
      continue;
    }
    clear(state.row);
    const EyeSample sample = {element_eye(state.scene, e), kRowOne, false};
    ASSERT_EQ(contour_row(state.scene, *state.settings.tables, sample, state.work, state.row), Status::ok);
    double factor = 0;
    for (unsigned j = 0; j < state.scene.element_count; ++j) {
      factor += flash_read(state.scene.elements, j).face == 3 ? state.row.share[j] / double{kRowOne} : 0;
    }
    const glm::dvec3 eye = solution.device().mesh.elements[e].centroid;
    const double exact = point_to_parallel({-eye.x, 1 - eye.x, -eye.z, 1 - eye.z}, 1.0);
    EXPECT_NEAR(factor, exact, kBound * exact);
  }
}

}  // namespace
}  // namespace fixrad::host

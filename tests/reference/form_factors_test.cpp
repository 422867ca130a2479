// SPDX-License-Identifier: MIT
#include "host_sim/reference/form_factors.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <stdexcept>

#include "tests/reference/grid_mesh.h"

namespace fixrad::host {
namespace {

// Closed forms between unit squares: parallel at distance 1, perpendicular with a common edge
// (J. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11 and C-14).
constexpr double kParallel = 0.19982489569838746;
constexpr double kPerpendicular = 0.20004377607540316;

const glm::dvec3 kX{1, 0, 0};
const glm::dvec3 kY{0, 1, 0};
const glm::dvec3 kZ{0, 0, 1};
const glm::dvec3 kOrigin{0.0};

/// Form factor between faces 0 and 1 of a mesh of two faces.
double between_faces(const ElementMesh& mesh, const FormFactorOptions& options = {}) {
  const FormFactors factors = form_factors(mesh, options);
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < factors.size; ++i) {
    if (mesh.elements[i].input_face == 0) {
      area += mesh.elements[i].area;
      for (std::size_t j = 0; j < factors.size; ++j) {
        sum += mesh.elements[j].input_face == 1 ? mesh.elements[i].area * factors.at(i, j) : 0.0;
      }
    }
  }
  return sum / area;
}

ElementMesh furnished_cube() {
  ElementMesh mesh = unit_cube(3, {}, {});
  add_grid(mesh, {0.3, 0.3, 0.4}, 0.4 * kY, 0.3 * kX, 2, 2, {});
  add_grid(mesh, {0.3, 0.3, 0.4}, 0.3 * kX, 0.4 * kY, 1, 2, {});
  return mesh;
}

TEST(FormFactors, ParallelUnitSquares) {
  for (const int n : {1, 3}) {
    ElementMesh mesh;
    add_grid(mesh, kOrigin, kX, kY, n, n, {});
    add_grid(mesh, kZ, kY, kX, 2, 1, {});
    EXPECT_NEAR(between_faces(mesh), kParallel, 1e-4 * kParallel) << n;
  }
}

TEST(FormFactors, PerpendicularUnitSquaresWithACommonEdge) {
  for (const int n : {1, 2, 5}) {
    ElementMesh mesh;
    add_grid(mesh, kOrigin, kX, kY, n, n, {});
    add_grid(mesh, kOrigin, kY, kZ, n, n, {});
    EXPECT_NEAR(between_faces(mesh), kPerpendicular, 1e-3 * kPerpendicular) << n;
  }
}

TEST(FormFactors, TouchingElementsOfVeryDifferentSize) {
  ElementMesh mesh;
  add_grid(mesh, kOrigin, kX, kY, 1, 1, {});
  add_grid(mesh, kOrigin, kY, kZ, 13, 7, {});
  EXPECT_NEAR(between_faces(mesh), kPerpendicular, 1e-3 * kPerpendicular);
}

TEST(FormFactors, TrianglesAddUpToTheirSquare) {
  ElementMesh mesh;
  add_grid(mesh, kOrigin, kX, kY, 1, 1, {});
  add_grid(mesh, kOrigin, kY, kZ, 1, 1, {});
  MeshElement lower = mesh.elements[1];
  MeshElement upper = lower;
  const std::vector<glm::dvec3> square = lower.polygon;
  lower.polygon = {square[0], square[1], square[2]};
  upper.polygon = {square[0], square[2], square[3]};
  lower.centroid = (square[0] + square[1] + square[2]) / 3.0;
  upper.centroid = (square[0] + square[2] + square[3]) / 3.0;
  lower.area = upper.area = 0.5;
  mesh.elements[1] = lower;
  mesh.elements.push_back(upper);
  EXPECT_NEAR(between_faces(mesh), kPerpendicular, 1e-3 * kPerpendicular);
}

TEST(FormFactors, ABlockerOverHalfOfADistantViewHidesHalf) {
  // Small squares far apart: a sheet that ends in their common axis hides exactly one half, by symmetry.
  ElementMesh mesh;
  add_grid(mesh, kOrigin, kX, kY, 1, 1, {});
  add_grid(mesh, 4.0 * kZ, kY, kX, 1, 1, {});
  const double open = between_faces(mesh);
  add_blocker(mesh, {0.5, -5, 2}, 10.0 * kX, 11.0 * kY);
  EXPECT_NEAR(between_faces(mesh), 0.5 * open, 0.01 * open);
  ElementMesh fine;
  add_grid(fine, kOrigin, kX, kY, 6, 6, {});
  add_grid(fine, 4.0 * kZ, kY, kX, 6, 6, {});
  add_blocker(fine, {0.5, -5, 2}, 10.0 * kX, 11.0 * kY);
  EXPECT_NEAR(between_faces(fine), 0.5 * open, 1e-3 * open);
}

TEST(FormFactors, ABlockerHidesFromBothSidesAltogether) {
  for (const glm::dvec3& u : {kX, -kX}) {
    ElementMesh mesh;
    add_grid(mesh, kOrigin, kX, kY, 1, 1, {});
    add_grid(mesh, kZ, kY, kX, 1, 1, {});
    add_blocker(mesh, glm::dvec3{0.5, -9, 0.5} - 9.0 * u, 18.0 * u, 18.0 * kY);
    EXPECT_EQ(between_faces(mesh), 0.0);
  }
}

TEST(FormFactors, AreZeroWithinAPlaneAndBehind) {
  ElementMesh mesh;
  add_grid(mesh, kOrigin, kX, kY, 2, 1, {});
  add_grid(mesh, kZ, kX, kY, 1, 1, {});  // looks up, away from the floor
  for (const double value : form_factors(mesh).values) {
    EXPECT_EQ(value, 0.0);
  }
}

TEST(FormFactors, AreReciprocal) {
  const ElementMesh mesh = furnished_cube();
  const FormFactors factors = form_factors(mesh);
  for (std::size_t i = 0; i < factors.size; ++i) {
    for (std::size_t j = 0; j < factors.size; ++j) {
      const double there = mesh.elements[i].area * factors.at(i, j);
      const double back = mesh.elements[j].area * factors.at(j, i);
      EXPECT_NEAR(there, back, 1e-12 * there) << i << ' ' << j;
    }
  }
}

TEST(FormFactors, RowsOfAClosedCubeAddUpToOne) {
  for (const int n : {1, 2, 5}) {
    for (const double sum : form_factors(unit_cube(n, {}, {})).row_sums()) {
      EXPECT_NEAR(sum, 1.0, 1e-3) << n;
    }
  }
}

TEST(FormFactors, RowsOfAClosedRoomWithATwoSidedSheetAddUpToOne) {
  // Hidden parts are found by rays, so a row is exact only in the mean.
  const ElementMesh mesh = furnished_cube();
  const std::vector<double> sums = form_factors(mesh).row_sums();
  double mean = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    EXPECT_NEAR(sums[i], 1.0, 0.02) << i;
    mean += mesh.elements[i].area * sums[i];
    area += mesh.elements[i].area;
  }
  EXPECT_NEAR(mean / area, 1.0, 2e-3);
}

FormFactorOptions few_far_rays() {
  FormFactorOptions options;
  options.far_rays = 4;
  return options;
}

TEST(FormFactors, FewFarRaysKeepTheRowsOfAClosedCube) {
  for (const double sum : form_factors(unit_cube(10, {}, {}), few_far_rays()).row_sums()) {
    EXPECT_NEAR(sum, 1.0, 1e-4);
  }
}

TEST(FormFactors, FewFarRaysFindHalfABlockedViewInTheMean) {
  ElementMesh mesh;
  add_grid(mesh, kOrigin, kX, kY, 16, 16, {});
  add_grid(mesh, 4.0 * kZ, kY, kX, 16, 16, {});
  const double open = between_faces(mesh, few_far_rays());
  add_blocker(mesh, {0.5, -5, 2}, 10.0 * kX, 11.0 * kY);
  EXPECT_NEAR(between_faces(mesh, few_far_rays()), 0.5 * open, 2e-3 * open);
}

TEST(FormFactors, EffortForManyElementsTakesFewFarRays) {
  EXPECT_EQ(effort_for(100).far_rays, 0U);
  EXPECT_EQ(effort_for(2000).far_rays, 4U);
}

TEST(FormFactors, DoNotDependOnTheNumberOfThreads) {
  const ElementMesh mesh = furnished_cube();
  const std::vector<double> parallel = form_factors(mesh).values;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(form_factors(mesh).values, parallel);
}

TEST(FormFactors, RefuseAnElementWithoutArea) {
  ElementMesh mesh = unit_cube(1, {}, {});
  mesh.elements[2].area = 0.0;
  EXPECT_THROW(form_factors(mesh), std::runtime_error);
}

}  // namespace
}  // namespace fixrad::host

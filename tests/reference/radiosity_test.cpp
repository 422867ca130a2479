// SPDX-License-Identifier: MIT
#include "host_sim/reference/radiosity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/reference/grid_mesh.h"

namespace fixrad::host {
namespace {

const glm::dvec3 kX{1, 0, 0};
const glm::dvec3 kY{0, 1, 0};

/// Exact form factors of the cube's faces, one element a face, in the order of unit_cube(): opposite faces
/// are neighbours 2k, 2k + 1. The closed form for parallel squares, the rest shared by the four others.
FormFactors exact_cube_factors() {
  constexpr double kParallel = 0.19982489569838746;
  FormFactors factors;
  factors.size = 6;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      const double perpendicular = (1.0 - kParallel) / 4.0;
      factors.values.push_back(i == j ? 0.0 : i / 2 == j / 2 ? kParallel : perpendicular);
    }
  }
  return factors;
}

TEST(Radiosity, CubeWithOneEmittingFaceMatchesTheExactSixBySixAnswer) {
  constexpr double kParallel = 0.19982489569838746;
  for (const double rho : {0.1, 0.5, 0.9, 0.99}) {
    const Paint walls{glm::dvec3{rho}, glm::dvec3{0.0}};
    const Paint floor{glm::dvec3{rho}, glm::dvec3{1.0}};
    const ElementMesh mesh = unit_cube(1, floor, walls);
    // By symmetry: floor b, ceiling c, four equal sides s. The modes of the symmetric system are known:
    // uniform (eigenvalue 1), floor + ceiling against sides ((3P - 1) / 2), floor against ceiling (-P).
    const double uniform = 1.0 / 6.0 / (1.0 - rho);
    const double axis = 1.0 / 3.0 / (1.0 - rho * (1.5 * kParallel - 0.5));
    const double against = 0.5 / (1.0 + rho * kParallel);
    const std::vector<glm::dvec3> radiosity = solve_radiosity(mesh, exact_cube_factors());
    EXPECT_NEAR(radiosity[0].x, uniform + axis + against, 1e-10 / (1.0 - rho)) << rho;
    EXPECT_NEAR(radiosity[1].x, uniform + axis - against, 1e-10 / (1.0 - rho)) << rho;
    for (std::size_t side = 2; side < 6; ++side) {
      EXPECT_NEAR(radiosity[side].x, uniform - 0.5 * axis, 1e-10 / (1.0 - rho)) << rho;
    }
    const std::vector<glm::dvec3> computed = solve_radiosity(mesh, form_factors(mesh));
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(computed[i].x / radiosity[i].x, 1.0, 3e-4 / (1.0 - rho)) << rho;
    }
  }
}

TEST(Radiosity, FurnaceIsUniformInEveryChannel) {
  const glm::dvec3 rho{0.1, 0.5, 0.9};
  const Paint paint{rho, {1.0, 2.0, 3.0}};
  const ElementMesh mesh = unit_cube(4, paint, paint);
  for (const glm::dvec3& radiosity : solve_radiosity(mesh, form_factors(mesh))) {
    for (glm::length_t channel = 0; channel < 3; ++channel) {
      const double expected = paint.emission[channel] / (1.0 - rho[channel]);
      EXPECT_NEAR(radiosity[channel], expected, 3e-3 * expected) << channel;
    }
  }
}

TEST(Radiosity, TheIterationAgreesWithTheFactorisation) {
  // 1014 elements are above the limit of the factorisation. The same answer by substitution: B = E + rho F B.
  const Paint floor{{0.7, 0.2, 0.0}, {1.0, 2.0, 3.0}};
  const Paint walls{{0.5, 0.95, 0.0}, glm::dvec3{0.0}};
  const ElementMesh mesh = unit_cube(13, floor, walls);
  const FormFactors factors = form_factors(mesh);
  const std::vector<glm::dvec3> radiosity = solve_radiosity(mesh, factors);
  ASSERT_GT(factors.size, 1000U);
  for (std::size_t i = 0; i < factors.size; i += 17) {
    glm::dvec3 irradiance{0.0};
    for (std::size_t j = 0; j < factors.size; ++j) {
      irradiance += factors.at(i, j) * radiosity[j];
    }
    const glm::dvec3 expected = mesh.elements[i].emission + mesh.elements[i].reflectance * irradiance;
    for (glm::length_t channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(radiosity[i][channel], expected[channel], 1e-9) << i;
    }
  }
}

TEST(Radiosity, FaceMeansWeighElementsByArea) {
  ElementMesh mesh;
  add_grid(mesh, {0, 0, 0}, kX, kY, 1, 1, {});
  add_grid(mesh, {0, 0, 1}, kX, kY, 2, 1, {});
  mesh.elements[1].area = 3.0;
  mesh.elements[2].area = 1.0;
  mesh.elements[1].input_face = mesh.elements[2].input_face = 2;
  const std::vector<glm::dvec3> values{glm::dvec3{5.0}, glm::dvec3{1.0, 2.0, 0.0}, glm::dvec3{9.0, 2.0, 4.0}};
  const std::vector<glm::dvec3> means = face_means(mesh, values);
  EXPECT_EQ(means, (std::vector<glm::dvec3>{glm::dvec3{5.0}, glm::dvec3{0.0}, glm::dvec3{3.0, 2.0, 1.0}}));
  const std::vector<glm::dvec3> errors = face_standard_errors(mesh, {{1, 1, 1}, {4, 0, 0}, {0, 4, 0}});
  EXPECT_EQ(errors[2], (glm::dvec3{3.0, 1.0, 0.0}));
}

TEST(Radiosity, RefusesFormFactorsOfAnotherMesh) {
  const ElementMesh mesh = unit_cube(2, {}, {});
  EXPECT_THROW(solve_radiosity(mesh, exact_cube_factors()), std::runtime_error);
  EXPECT_THROW(face_means(mesh, std::vector<glm::dvec3>(3)), std::runtime_error);
}

TEST(Radiosity, RefusesAGainOfEnergy) {
  FormFactors factors = exact_cube_factors();
  for (double& value : factors.values) {
    value *= 1.2;
  }
  const Paint paint{glm::dvec3{0.9}, glm::dvec3{1.0}};
  EXPECT_THROW(solve_radiosity(unit_cube(1, paint, paint), factors), std::runtime_error);
}

}  // namespace
}  // namespace fixrad::host

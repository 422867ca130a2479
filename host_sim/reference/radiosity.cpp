// SPDX-License-Identifier: MIT
#include "host_sim/reference/radiosity.h"

#include <Eigen/Cholesky>
#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <stdexcept>
#include <string>

namespace fixrad::host {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

constexpr Eigen::Index kLargestFactorised = 1000;
constexpr double kResidual = 1e-12;

[[noreturn]] void refuse_gain() {
  throw std::runtime_error(
      "the radiosity system gains energy: the form factors' row sums exceed 1 by more than this reflectance "
      "allows; compute them with a smaller quadrature tolerance");
}

Vector solve_symmetric(const Matrix& system, const Vector& right) {
  if (system.rows() <= kLargestFactorised) {
    const Eigen::LLT<Matrix> factorised(system);
    if (factorised.info() != Eigen::Success) {
      refuse_gain();
    }
    return factorised.solve(right);
  }
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> iteration(system);
  iteration.setTolerance(kResidual);
  Vector solution = iteration.solve(right);
  if (iteration.info() != Eigen::Success || !solution.allFinite()) {
    refuse_gain();
  }
  return solution;
}

/// One channel. With S = diag(sqrt A), R = diag(sqrt rho) and H = F B the irradiance, y = R S H obeys
/// (1 - R G R) y = R S F E, where G = S F S^-1 is symmetric by reciprocity. B = E + R S^-1 y needs no
/// division by rho, so that black elements are nothing special.
Vector solve_channel(const Eigen::Map<const Matrix>& factors, const Vector& root_area,
                     const Vector& reflectance, const Vector& emission) {
  const Vector root_reflectance = reflectance.cwiseSqrt();
  const Vector left = root_reflectance.cwiseProduct(root_area);
  const Vector right = root_reflectance.cwiseQuotient(root_area);
  Matrix system = -(left.asDiagonal() * factors * right.asDiagonal());
  system.diagonal().array() += 1.0;
  const Vector source = left.cwiseProduct(factors * emission);
  return emission + right.cwiseProduct(solve_symmetric(system, source));
}

std::size_t face_count(const ElementMesh& mesh) {
  std::size_t count = 0;
  for (const MeshElement& element : mesh.elements) {
    count = std::max(count, std::size_t{element.input_face} + 1);
  }
  return count;
}

std::vector<double> face_areas(const ElementMesh& mesh) {
  std::vector<double> areas(face_count(mesh), 0.0);
  for (const MeshElement& element : mesh.elements) {
    areas[element.input_face] += element.area;
  }
  return areas;
}

void check_size(const ElementMesh& mesh, std::size_t size) {
  if (mesh.elements.size() != size) {
    throw std::runtime_error("a mesh of " + std::to_string(mesh.elements.size()) + " elements was given " +
                             std::to_string(size) + " values; compute them for this mesh");
  }
}

}  // namespace

std::vector<glm::dvec3> solve_radiosity(const ElementMesh& mesh, const FormFactors& factors) {
  check_size(mesh, factors.size);
  const auto size = static_cast<Eigen::Index>(factors.size);
  const Eigen::Map<const Matrix> matrix(factors.values.data(), size, size);
  std::vector<glm::dvec3> radiosity(factors.size);
  Vector root_area(size);
  Vector reflectance(size);
  Vector emission(size);
  for (glm::length_t channel = 0; channel < 3; ++channel) {
    for (Eigen::Index i = 0; i < size; ++i) {
      const MeshElement& element = mesh.elements[static_cast<std::size_t>(i)];
      root_area[i] = std::sqrt(element.area);
      reflectance[i] = element.reflectance[channel];
      emission[i] = element.emission[channel];
    }
    const Vector solved = solve_channel(matrix, root_area, reflectance, emission);
    for (Eigen::Index i = 0; i < size; ++i) {
      radiosity[static_cast<std::size_t>(i)][channel] = solved[i];
    }
  }
  return radiosity;
}

std::vector<glm::dvec3> face_means(const ElementMesh& mesh, const std::vector<glm::dvec3>& values) {
  check_size(mesh, values.size());
  const std::vector<double> areas = face_areas(mesh);
  std::vector<glm::dvec3> means(areas.size(), glm::dvec3{0.0});
  for (std::size_t i = 0; i < values.size(); ++i) {
    const MeshElement& element = mesh.elements[i];
    means[element.input_face] += element.area / areas[element.input_face] * values[i];
  }
  return means;
}

std::vector<glm::dvec3> face_standard_errors(const ElementMesh& mesh,
                                             const std::vector<glm::dvec3>& standard_errors) {
  check_size(mesh, standard_errors.size());
  const std::vector<double> areas = face_areas(mesh);
  std::vector<glm::dvec3> errors(areas.size(), glm::dvec3{0.0});
  for (std::size_t i = 0; i < standard_errors.size(); ++i) {
    const MeshElement& element = mesh.elements[i];
    const glm::dvec3 part = element.area / areas[element.input_face] * standard_errors[i];
    errors[element.input_face] += part * part;
  }
  std::transform(errors.begin(), errors.end(), errors.begin(),
                 [](const glm::dvec3& variance) { return glm::sqrt(variance); });
  return errors;
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/element_mesh.h"
#include "host_sim/reference/form_factors.h"

namespace fixrad::host {

/// Solves the radiosity equation B_i = E_i + rho_i * sum over j of F_ij B_j in double precision, channel by
/// channel. Its symmetric form is factorised (Cholesky) up to 1000 elements, above that solved by conjugate
/// gradients to a residual of 1e-12.
/// @param mesh     reflectance in [0, 1), emission >= 0
/// @param factors  form_factors(mesh): reciprocal
/// @return B of each element, W/m^2, in the order of the mesh
/// @throws std::runtime_error when factors are of another mesh, or when the system gains energy: row sums
/// that
///         exceed 1 by more than 1 - rho allows. Finer FormFactorOptions help.
/// Cost: size^3 / 3 operations, or size^2 an iteration, a channel; one further matrix of size^2 * 8 bytes.
std::vector<glm::dvec3> solve_radiosity(const ElementMesh& mesh, const FormFactors& factors);

/// Area-weighted mean over the elements of each input face.
/// @param values  one an element
/// @return indexed by input face, as long as the largest face number + 1; 0 for a face without elements
std::vector<glm::dvec3> face_means(const ElementMesh& mesh, const std::vector<glm::dvec3>& values);

/// Standard error of face_means() from independent standard errors of the elements.
std::vector<glm::dvec3> face_standard_errors(const ElementMesh& mesh,
                                             const std::vector<glm::dvec3>& standard_errors);

}  // namespace fixrad::host

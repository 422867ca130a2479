// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_sim/meshing/element_mesh.h"

namespace fixrad::host {

/// How hard to work on each pair of elements. The defaults keep an unblocked pair within about 0.1 %.
struct FormFactorOptions {
  /// A cell of a near pair is split until that changes the pair's form factor by less than this part of it.
  double quadrature_tolerance = 1e-3;
  int quadrature_depth = 5;         ///< splits in four, at most
  std::uint32_t probe_rays = 4;     ///< rays a sample point at first; powers of two are best
  std::uint32_t partial_rays = 16;  ///< and where the first rays disagree
  /// 0, or as many rays (8 at most) for a whole pair that is far apart. A half hidden pair is then off by
  /// some tenths of itself, without bias: right for thousands of elements, whose errors average out in every
  /// row.
  std::uint32_t far_rays = 0;
};

/// What face means deserve on a mesh of so many elements: up to 600 every pair counts and many rays are
/// cheap; above, distant pairs take far_rays, which is several times faster and leaves face means within 0.1
/// %.
FormFactorOptions effort_for(std::size_t elements);

/// Area-averaged form factors between all pairs of elements of a mesh.
struct FormFactors {
  std::size_t size = 0;  ///< elements
  std::vector<double>
      values;  ///< F_ij at [i * size + j], in [0, 1]: the part of i's flux that reaches j directly

  double at(std::size_t i, std::size_t j) const { return values[i * size + j]; }

  /// Sum over j of F_ij for each i: 1 in a closed scene but for the error of the form factors (nothing is
  /// normalised), less where i also sees back faces or the open.
  std::vector<double> row_sums() const;
};

/// Form factors from closed-form contour integrals at quadrature points of the smaller element, graded where
/// the two are near, times the fraction of evenly spread rays that get through between them, more of them
/// where the first disagree. Reciprocity A_i F_ij = A_j F_ji holds but for the rounding of a division. The
/// result depends on mesh and options only, not on the number of threads. Cost: size^2 * 8 bytes and about
/// size^2 / 2 * (16 rays + 4 contours): 1500 elements take some 3 s on two cores, with far_rays 0.5 s.
/// @throws std::runtime_error when the mesh has an element with fewer than three corners or no area
FormFactors form_factors(const ElementMesh& mesh, const FormFactorOptions& options = {});

}  // namespace fixrad::host

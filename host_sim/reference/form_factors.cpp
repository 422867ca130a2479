// SPDX-License-Identifier: MIT
#include "host_sim/reference/form_factors.h"

#include <tbb/parallel_for.h>

#include <numeric>
#include <stdexcept>
#include <string>

#include "host_sim/reference/exchange.h"

namespace fixrad::host {
namespace {

constexpr std::size_t kFewElements = 600;

void check_elements(const ElementMesh& mesh) {
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    if (mesh.elements[i].polygon.size() < 3 || !(mesh.elements[i].area > 0.0)) {
      throw std::runtime_error("element " + std::to_string(i) + " has no area; leave it out of the mesh");
    }
  }
}

}  // namespace

std::vector<double> FormFactors::row_sums() const {
  std::vector<double> sums(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double* row = values.data() + i * size;
    sums[i] = std::accumulate(row, row + size, 0.0);
  }
  return sums;
}

FormFactorOptions effort_for(std::size_t elements) {
  FormFactorOptions options;
  if (elements <= kFewElements) {
    options.probe_rays = 8;
  } else {
    options.far_rays = 4;
  }
  return options;
}

FormFactors form_factors(const ElementMesh& mesh, const FormFactorOptions& options) {
  check_elements(mesh);
  const std::vector<MeshElement>& elements = mesh.elements;
  const RayScene scene(mesh.blocker_positions, mesh.blocker_triangles);
  FormFactors result;
  result.size = elements.size();
  result.values.assign(result.size * result.size, 0.0);
  tbb::parallel_for(std::size_t{0}, result.size, [&](std::size_t i) {
    for (std::size_t j = i + 1; j < result.size; ++j) {
      const double exchange_area = exchange(elements[i], elements[j], scene, options, i * result.size + j);
      result.values[i * result.size + j] = exchange_area / elements[i].area;
      result.values[j * result.size + i] = exchange_area / elements[j].area;
    }
  });
  return result;
}

}  // namespace fixrad::host

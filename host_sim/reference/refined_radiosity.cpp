// SPDX-License-Identifier: MIT
#include "host_sim/reference/refined_radiosity.h"

#include <algorithm>
#include <limits>

#include "host_sim/meshing/contact_lines.h"
#include "host_sim/reference/error_budget.h"
#include "host_sim/reference/form_factors.h"
#include "host_sim/reference/radiosity.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kElementsPerFace = 6;

std::vector<glm::dvec3> solve(const PreparedScene& scene, std::uint32_t wanted, std::uint32_t& elements) {
  Meshing meshing = make_uniform(scene, wanted, wanted);
  cut_at_contacts(scene, meshing);
  const DeviceScene device = make_device_scene(scene, meshing);
  const ElementMesh& mesh = device.mesh;
  elements = static_cast<std::uint32_t>(mesh.elements.size());
  return face_means(*scene.model, device.overlaps,
                    solve_radiosity(mesh, form_factors(mesh, effort_for(mesh.elements.size()))));
}

}  // namespace

RefinedRadiosity refined_radiosity(const PreparedScene& scene, const RefinementOptions& options) {
  const Model& model = *scene.model;
  const std::vector<double> areas = face_areas(model);
  std::vector<bool> emits;
  for (const Face& face : model.faces) {
    emits.push_back(model.materials[face.material].emission != glm::dvec3(0.0));
  }
  RefinedRadiosity result;
  result.change = std::numeric_limits<double>::infinity();
  const auto faces = static_cast<std::uint32_t>(scene.faces.size());
  std::uint32_t wanted =
      std::min(std::max(options.first_elements, kElementsPerFace * faces), options.most_elements);
  for (;; wanted *= 2) {
    const std::vector<glm::dvec3> means = solve(scene, wanted, result.elements);
    if (!result.face_means.empty()) {
      result.change = compare_face_means(result.face_means, means, areas, emits).mean;
    }
    result.face_means = means;
    result.settled = result.change <= options.tolerance;
    if (result.settled || 2 * wanted > options.most_elements) {
      return result;
    }
  }
}

}  // namespace fixrad::host

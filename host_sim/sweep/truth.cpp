// SPDX-License-Identifier: MIT
#include "host_sim/sweep/truth.h"

#include "host_sim/reference/input_polygons.h"
#include "host_sim/reference/path_tracer.h"

namespace fixrad::host {

Truth trace_truth(const PreparedScene& scene) {
  const Model& model = *scene.model;
  Truth truth;
  truth.areas = face_areas(model);
  for (const Face& face : model.faces) {
    truth.emits.push_back(model.materials[face.material].emission != glm::dvec3(0.0));
  }
  Traced traced = path_traced_faces(input_polygons(scene));
  traced.mean.resize(model.faces.size(), glm::dvec3(0.0));  // the last faces may have no polygons
  traced.standard_error.resize(model.faces.size(), glm::dvec3(0.0));
  truth.means = traced.mean;
  std::vector<glm::dvec3> off = traced.mean;
  for (std::size_t f = 0; f < off.size(); ++f) {
    off[f] += traced.standard_error[f];
  }
  truth.standard_error = compare_face_means(off, truth.means, truth.areas, truth.emits).mean;
  return truth;
}

FaceMeanError error_against(const Truth& truth, const PreparedScene& scene, const DeviceScene& device,
                            const std::vector<glm::dvec3>& element_radiosity) {
  return compare_face_means(face_means(*scene.model, device.overlaps, element_radiosity), truth.means,
                            truth.areas, truth.emits);
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/sweep/truth.h"

#include <algorithm>
#include <glm/exponential.hpp>

#include "host_sim/reference/path_tracer.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kPaths = 4000000;      // shared among the elements
constexpr std::uint32_t kTruthElements = 400;  // only where paths start; the traced geometry is exact

// Elements are independent, so the variances of a face's elements add up.
double mean_standard_error(const Model& model, const std::vector<Overlap>& overlaps,
                           const std::vector<glm::dvec3>& errors, const Truth& truth) {
  std::vector<glm::dvec3> variance(model.faces.size(), glm::dvec3(0.0));
  for (const Overlap& o : overlaps) {
    const glm::dvec3 part = o.area / truth.areas[o.input_face] * errors[o.element];
    variance[o.input_face] += part * part;
  }
  for (std::size_t f = 0; f < variance.size(); ++f) {
    variance[f] = truth.means[f] + glm::sqrt(variance[f]);
  }
  return compare_face_means(variance, truth.means, truth.areas, truth.emits).mean;
}

}  // namespace

Truth trace_truth(const PreparedScene& scene) {
  const Model& model = *scene.model;
  Truth truth;
  truth.areas = face_areas(model);
  for (const Face& face : model.faces) {
    truth.emits.push_back(model.materials[face.material].emission != glm::dvec3(0.0));
  }
  const DeviceScene device = make_device_scene(scene, make_uniform(scene, kTruthElements, kTruthElements));
  PathTracingOptions options;
  options.paths_per_element = std::max(64u, kPaths / static_cast<std::uint32_t>(device.elements.size()));
  const PathTracedRadiosity traced = path_traced_radiosity(device.mesh, options);
  truth.means = face_means(model, device.overlaps, traced.mean);
  truth.standard_error = mean_standard_error(model, device.overlaps, traced.standard_error, truth);
  return truth;
}

FaceMeanError error_against(const Truth& truth, const PreparedScene& scene, const DeviceScene& device,
                            const std::vector<glm::dvec3>& element_radiosity) {
  return compare_face_means(face_means(*scene.model, device.overlaps, element_radiosity), truth.means,
                            truth.areas, truth.emits);
}

}  // namespace fixrad::host

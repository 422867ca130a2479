// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>

#include "host_sim/cli/session.h"
#include "host_sim/reference/path_tracer.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kTruthElements = 400;  // only where paths start; the traced geometry is exact

struct FaceTruth {
  std::vector<glm::dvec3> mean, standard_error;  // [model.faces], W/m^2
};

// Elements are independent, so the variances of a face's elements add up.
FaceTruth trace(const LoadedScene& scene, const std::vector<double>& areas, std::uint32_t paths) {
  const DeviceScene device =
      make_device_scene(scene.prepared, make_uniform(scene.prepared, kTruthElements, kTruthElements));
  PathTracingOptions options;
  options.paths_per_element = std::max(64u, paths / static_cast<std::uint32_t>(device.elements.size()));
  const PathTracedRadiosity traced = path_traced_radiosity(device.mesh, options);
  std::vector<glm::dvec3> variance(scene.model.faces.size(), glm::dvec3(0.0));
  for (const Overlap& o : device.overlaps) {
    const glm::dvec3 part = o.area / areas[o.input_face] * traced.standard_error[o.element];
    variance[o.input_face] += part * part;
  }
  for (glm::dvec3& v : variance) {
    v = glm::sqrt(v);
  }
  return {face_means(scene.model, device.overlaps, traced.mean), variance};
}

std::string csv(const Model& model, const std::vector<double>& areas, const FaceTruth& truth) {
  std::string text = "face,material,emits,area,B_r,B_g,B_b,error_r,error_g,error_b\n";
  const auto brightness = [](glm::dvec3 b) { return b.x + b.y + b.z; };
  for (std::size_t f = 0; f < model.file_faces; ++f) {
    // With --two-sided, the brighter side, as in `bake --faces-csv`.
    const std::size_t other = f + model.file_faces;
    const bool turned =
        other < model.faces.size() && brightness(truth.mean[other]) > brightness(truth.mean[f]);
    const glm::dvec3 b = truth.mean[turned ? other : f], error = truth.standard_error[turned ? other : f];
    const Material& material = model.materials[model.faces[f].material];
    text += std::to_string(f) + "," + csv_field(material.name) +
            (material.emission != glm::dvec3(0.0) ? ",1" : ",0");
    for (const double value : {areas[f], b.x, b.y, b.z, error.x, error.y, error.z}) {
      text += ",";
      append_number(text, value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

int run_truth(const CommonOptions& options) {
  check_folder(options.csv);
  const auto scene = load_scene(options);
  exit_on_interrupt();
  const std::vector<double> areas = face_areas(scene->model);
  const FaceTruth truth = trace(*scene, areas, options.paths);
  catch_interrupt();
  write_text(options.csv, csv(scene->model, areas, truth));
  say(options, "wrote " + options.csv);
  return kDone;
}

}  // namespace fixrad::host

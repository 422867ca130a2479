// SPDX-License-Identifier: MIT
#include "host_sim/cli/session.h"
#include "host_sim/reference/input_polygons.h"
#include "host_sim/reference/path_tracer.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

std::string csv(const Model& model, const std::vector<double>& areas, const Traced& truth) {
  std::string text = "face,material,emits,area,B_r,B_g,B_b,error_r,error_g,error_b\n";
  for (std::size_t f = 0; f < model.file_faces; ++f) {
    // With --two-sided, the brighter side, as in `bake --faces-csv`.
    const std::size_t other = f + model.file_faces;
    const bool turned =
        other < model.faces.size() && channel_sum(truth.mean[other]) > channel_sum(truth.mean[f]);
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
  FaceTracingOptions choice;
  choice.paths = options.paths;
  const Traced truth = path_traced_faces(input_polygons(scene->prepared), choice);
  catch_interrupt();
  write_text(options.csv, csv(scene->model, areas, truth));
  say(options, "wrote " + options.csv);
  return kDone;
}

}  // namespace fixrad::host

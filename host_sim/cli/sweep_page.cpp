// SPDX-License-Identifier: MIT
#include "host_sim/cli/sweep_page.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/report/data_page.h"
#include "host_sim/report/error_map.h"

namespace fixrad::host {
namespace {

using Json = nlohmann::ordered_json;

// Figures of the CSV, so that both say the same.
double percent(double part) {
  return std::round(part * 1e6) / 1e4;
}

Json targets() {
  Json list = Json::array();
  for (const CostModel& model : cost_models()) {
    list.push_back({{"id", model.target},
                    {"unit", model.unit},
                    {"residual", percent(model.residual)},
                    {"measurements", model.measurements},
                    {"engines", model.engines}});
  }
  return list;
}

Json point_json(const SweepPoint& point, const std::string& command_start) {
  Json costs = Json::object();
  for (const CostModel& model : cost_models()) {
    if (const std::optional<double> cost = cost_on(model, point)) {
      costs[model.target] = static_cast<std::uint64_t>(*cost);
    }
  }
  return {{"profile", point.options.profile},
          {"engine", point.options.engine},
          {"resolution", point.resolution},
          {"flux_per_row", point.flux_per_row},
          {"flux_per_eye", point.flux_per_eye},
          {"elements", point.elements},
          {"patches", point.patches},
          {"shots", point.shots},
          {"eyes", point.eyes},
          {"ram", point.ram_bytes},
          {"error", percent(point.mean_error)},
          {"worst", percent(point.worst_error)},
          {"seconds", point.host_seconds},
          {"costs", costs},
          {"command", command_start + " " + point.command}};
}

Json views_json(const Views& views) {
  return {{"picture", views.picture},
          {"model", views.model},
          {"point_errors", views.point_errors},
          {"face_errors", views.face_errors}};
}

// In the axes of the model, which is glTF: +Y is up.
Json camera_json(const Camera& camera, bool z_up) {
  const auto vector = [z_up](const glm::dvec3& v) {
    return z_up ? Json{v.x, v.z, -v.y} : Json{v.x, v.y, v.z};
  };
  return {{"eye", vector(camera.eye)}, {"target", vector(camera.target)}, {"fov", camera.vertical_fov}};
}

Json showcase_json(const Showcase& showcase, bool z_up) {
  Json json = {{"width", showcase.width},
               {"height", showcase.height},
               {"point_limit", 100 * showcase.point_limit},
               {"face_limit", 100 * showcase.face_limit},
               {"camera", camera_json(showcase.camera, z_up)},
               {"colours", kErrorColours},
               {"reference", views_json(showcase.reference)},
               {"solutions", Json::array()}};
  json["reference"]["elements"] = showcase.reference_elements;
  json["reference"]["error"] = percent(showcase.reference_error);
  for (std::size_t i = 0; i < showcase.points.size(); ++i) {
    json["solutions"].push_back(views_json(showcase.views[i]));
    json["solutions"].back()["point"] = showcase.points[i];
  }
  return json;
}

}  // namespace

std::string sweep_page(const CommonOptions& options, const std::string& command_start, const Truth& truth,
                       const std::vector<SweepPoint>& points, const Showcase& showcase) {
  const std::string name = std::filesystem::path(options.scene).stem().string();
  Json json = {{"scene", name},
               {"truth_error", percent(truth.standard_error)},
               {"unshot", 100 * options.bake.unshot},
               {"targets", targets()},
               {"points", Json::array()},
               {"showcase", showcase_json(showcase, options.display.z_up)}};
  for (const SweepPoint& point : points) {
    json["points"].push_back(point_json(point, command_start));
  }
  return page_with(json.dump(-1, ' ', false, Json::error_handler_t::replace), name);
}

}  // namespace fixrad::host

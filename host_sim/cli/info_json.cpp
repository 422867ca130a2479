// SPDX-License-Identifier: MIT
#include "host_sim/cli/info_page.h"

#include <nlohmann/json.hpp>

namespace fixrad::host {
namespace {

using Json = nlohmann::ordered_json;

Json extent_json(const Extent& extent) {
  return {extent.least, extent.most};
}

Json needs_json(const SceneNeeds& needs) {
  return {{"channels", needs.result.device.channels},
          {"closed", needs.result.is_closed},
          {"enclosed", needs.is_enclosed},
          {"convex", needs.is_convex},
          {"edges", needs.edges},
          {"open_edges", needs.open_edges},
          {"sealed_faces", needs.sealed_faces},
          {"buried_elements", needs.buried_elements},
          {"lamp_elements", needs.lamp_elements},
          {"lamp_watts", extent_json(needs.lamp_watts)},
          {"element_area", extent_json(needs.element_area)},
          {"radiosity", extent_json(needs.radiosity)},
          {"unit_watts", needs.result.device.unit_watts},
          {"darkest_units", needs.darkest_units},
          {"spans", needs.result.spans_used},
          {"shots", needs.result.shots},
          {"eyes", needs.result.eyes},
          {"views_without_depth", needs.views_without_depth}};
}

Json omissions_json(const SceneNeeds& needs, const CostModel& model) {
  Json all = Json::array();
  for (const Omission& omission : needs.omissions) {
    all.push_back({{"name", omission.name},
                   {"text", omission.text},
                   {"ram_bytes", omission.ram},
                   {model.unit, omission.cost ? Json(*omission.cost) : Json()}});
  }
  return all;
}

Json point_json(const std::optional<SweepPoint>& point) {
  return point ? Json{{"profile", point->options.profile},
                      {"elements", point->elements},
                      {"ram_bytes", point->ram_bytes},
                      {"mean_error", point->mean_error}}
               : Json();
}

Json profiles_json(const std::vector<ProfileCost>& profiles) {
  Json all = Json::array();
  for (const ProfileCost& cost : profiles) {
    Json row = {
        {"profile", cost.profile.name}, {"limit", cost.profile.ram_bytes}, {"fits", cost.plan.has_value()}};
    if (cost.plan) {
      row["elements"] = cost.plan->sizes.elements;
      row["patches"] = cost.plan->meshing.patch_count;
      row["resolution"] = cost.plan->resolution;
      row["ram_bytes"] = cost.plan->ram();
      row["rom_bytes"] = cost.rom_bytes;
    }
    all.push_back(row);
  }
  return all;
}

}  // namespace

Json info_json(const InfoPage& page) {
  const SceneNeeds& needs = page.needs;
  Json json = {{"scene", page.scene->model.path},
               {"profile", page.options->bake.profile},
               {"elements", needs.result.plan.sizes.elements},
               {"needs", needs_json(needs)},
               {"target", page.model->target},
               {page.model->unit, needs.cost ? Json(*needs.cost) : Json()},
               {"left_out", omissions_json(needs, *page.model)}};
  if (page.wanted) {
    json["wanted_error"] = {{"max_error", page.wanted->max_error},
                            {"truth_standard_error", page.wanted->truth_standard_error},
                            {"enough", point_json(page.wanted->need.enough)},
                            {"too_few", point_json(page.wanted->need.too_few)},
                            {"closest", point_json(page.wanted->need.closest)}};
  }
  json["profiles"] = profiles_json(page.profiles);
  return json;
}

}  // namespace fixrad::host

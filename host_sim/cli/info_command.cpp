// SPDX-License-Identifier: MIT
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/cli/info_page.h"
#include "host_sim/cli/search_options.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

// The core that stands for a profile's chips.
std::string usual_target(const std::string& profile) {
  return profile == "tiny"     ? "atmega2560"
         : profile == "small"  ? "cortex-m0"
         : profile == "medium" ? "cortex-m3"
                               : "cortex-m4f";
}

std::vector<ProfileCost> profile_costs(const PreparedScene& scene, BakeOptions options) {
  std::vector<ProfileCost> costs;
  for (const Profile& profile : profiles()) {
    options.profile = profile.name;
    ProfileCost cost = {profile, std::nullopt, 0};
    try {
      cost.plan = make_plan(scene, options);
      cost.rom_bytes = make_device_scene(scene, cost.plan->meshing).rom_bytes();
    } catch (const InputError&) {
      cost.plan.reset();
    }
    costs.push_back(cost);
  }
  return costs;
}

WantedError search(const CommonOptions& options, const PreparedScene& scene, double max_error) {
  exit_on_interrupt();
  const Truth truth = trace_truth(scene);
  catch_interrupt();
  Counter counter(options, 0);
  const Solve solve = [&](const BakeOptions& setting) {
    counter.next(setting);
    return solve_setting(scene, truth, setting,
                         [](std::uint32_t, double, double) { return !is_interrupted(); });
  };
  return {max_error, truth.standard_error, find_elements(scene, max_error, options.bake, solve)};
}

}  // namespace

int run_info(const CommonOptions& options, const InfoOptions& info) {
  check_folder(options.json);
  const auto scene = load_scene(options);
  InfoPage page;
  page.scene = scene.get();
  page.options = &options;
  page.model = find_cost_model(info.target.empty() ? usual_target(options.bake.profile) : info.target);
  {
    ProgressBar bar(options);
    page.needs = find_needs(scene->prepared, options.bake, *page.model,
                            [&](std::uint32_t shots, double unshot, double seconds) {
                              return bar.update(shots, unshot, seconds);
                            });
  }
  if (page.needs.result.interrupted) {
    return kInterrupted;
  }
  if (info.max_error_percent) {
    page.wanted = search(options, scene->prepared, *info.max_error_percent / 100);
    if (page.wanted->need.interrupted) {
      return kInterrupted;
    }
  }
  page.profiles = profile_costs(scene->prepared, options.bake);
  std::fputs(info_text(page).c_str(), stdout);
  for (const std::string& line : explain(scene->prepared, page.needs.result)) {
    say(options, line);
  }
  if (!options.json.empty()) {
    write_text(options.json, info_json(page).dump(2) + "\n");
  }
  return kDone;
}

}  // namespace fixrad::host

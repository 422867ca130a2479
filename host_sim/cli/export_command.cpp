// SPDX-License-Identifier: MIT
#include <filesystem>

#include "host_sim/cli/session.h"
#include "host_sim/report/write_scene.h"

namespace fixrad::host {
namespace {

SceneTable scene_table(const CommonOptions& options, const BakeResult& result) {
  SceneTable table;
  table.source = std::filesystem::path(options.scene).filename().string();
  table.profile = result.plan.profile.name;
  table.chip = result.plan.profile.chip;
  table.scene = result.device.view();
  table.map = result.surface.map();
  table.sizes = result.plan.sizes;
  table.settings = make_settings(options.bake, result.plan);
  table.unit_watts = result.device.unit_watts;
  table.unit_radiosity = result.device.unit_radiosity;
  table.digest = result.digest;
  table.shots = result.shots;
  table.eyes = result.eyes;
  table.ledger = result.ledger;
  table.received = result.received;
  return table;
}

}  // namespace

int run_export(const CommonOptions& options) {
  if (options.bake.solver == "gathering") {
    throw InputError("fixrad: error: the device's solver shoots; leave out --solver gathering");
  }
  const std::string& file = options.outputs.front();
  check_folder(file);
  const auto scene = load_scene(options);
  BakeResult result;
  {
    ProgressBar bar(options);
    result = bake(scene->prepared, options.bake, [&](std::uint32_t shots, double unshot, double seconds) {
      return bar.update(shots, unshot, seconds);
    });
  }
  if (result.interrupted) {
    say(options, "interrupted: nothing written");
    return kInterrupted;
  }
  for (const std::string& line : explain(scene->prepared, result)) {
    say(options, line);
  }
  write_scene(file, scene_table(options, result));
  say(options, "wrote " + file + ": " + std::to_string(result.plan.sizes.elements) + " elements, " +
                   std::to_string(result.shots) + " shots, " + std::to_string(result.plan.ram()) +
                   " bytes of RAM");
  return kDone;
}

}  // namespace fixrad::host

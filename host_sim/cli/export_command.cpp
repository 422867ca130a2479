// SPDX-License-Identifier: MIT
#include <filesystem>

#include "host_sim/cli/session.h"
#include "host_sim/report/write_scene.h"

namespace fixrad::host {
namespace {

// What a device draws once it has solved the scene, and the pixels that must come out.
void add_picture(const CommonOptions& options, const LoadedScene& scene, const BakeResult& result,
                 SceneTable& table) {
  const BakedMesh mesh = make_baked_mesh(scene, result);
  const DeviceUnits units = {result.device.grid, result.device.unit_radiosity, result.device.channels};
  table.picture = make_picture_table(mesh, units, options.display, options.picture.options());
  table.picture_digest = picture_digest(
      draw_on_device(*table.picture, exposed_light(mesh, units, *table.picture)), units.channels);
}

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
  SceneTable table = scene_table(options, result);
  if (options.picture.is_sized) {
    add_picture(options, *scene, result, table);
  }
  write_scene(file, table);
  say(options, "wrote " + file + ": " + std::to_string(result.plan.sizes.elements) + " elements, " +
                   std::to_string(result.shots) + " shots, " + std::to_string(result.plan.ram()) +
                   " bytes of RAM");
  return kDone;
}

}  // namespace fixrad::host

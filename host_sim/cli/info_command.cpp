// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string>

#include "host_sim/cli/session.h"

namespace fixrad::host {
namespace {

void print_row(const Profile& profile, const std::string& rest) {
  std::printf("  %-7s %9u  %-28s %s\n", profile.name.c_str(), profile.ram_bytes, profile.chip.c_str(),
              rest.c_str());
}

void print_profile(const LoadedScene& scene, BakeOptions options, const Profile& profile) {
  options.profile = profile.name;
  try {
    const BakePlan plan = make_plan(scene.prepared, options);
    char text[160];
    std::snprintf(text, sizeof text, "%8u %8u %6d %9u %9zu", plan.sizes.elements, plan.meshing.patch_count,
                  plan.resolution, plan.ram(), make_device_scene(scene.prepared, plan.meshing).rom_bytes());
    print_row(profile, text);
  } catch (const InputError&) {
    print_row(profile, "does not fit");
  }
}

}  // namespace

int run_info(const CommonOptions& options) {
  const auto scene = load_scene(options);
  BakeResult result;
  {
    ProgressBar bar(options);
    result = bake(scene->prepared, options.bake, [&](std::uint32_t shots, double unshot, double seconds) {
      return bar.update(shots, unshot, seconds);
    });
  }
  if (result.interrupted) {
    return kInterrupted;
  }
  std::printf("%s\n", scene->model.path.c_str());
  std::printf("  input faces        %zu, as %u convex planar faces\n", scene->model.file_faces,
              result.plan.sizes.faces);
  std::printf("  vertices           %u on the grid, moved by at most %.3g scene units\n",
              result.plan.sizes.vertices, scene->prepared.vertices.largest_error);
  std::printf("  colour             %s\n",
              scene->prepared.channels == 1 ? "grey: one channel is carried" : "three channels");
  std::printf("  closed             %s\n", result.is_closed
                                               ? "yes: back faces are not drawn, no light can escape"
                                               : "no: back faces block and are counted");
  std::printf("  span pool          %u used of %u (profile %s, R = %d)\n", result.spans_used,
              result.plan.sizes.spans, options.bake.profile.c_str(), result.plan.resolution);
  std::printf(
      "  shots to %.3g %%     %u, from %u eye points (%u buried ones thrown away), %.2f s on this machine\n",
      100 * options.bake.unshot, result.shots, result.eyes, result.withdrawn, result.seconds);
  std::printf(
      "\n  profile       RAM  chip                         elements  patches      R  RAM used     flash\n");
  for (const Profile& profile : profiles()) {
    print_profile(*scene, options.bake, profile);
  }
  for (const std::string& line : explain(scene->prepared, result)) {
    say(options, line);
  }
  return kDone;
}

}  // namespace fixrad::host

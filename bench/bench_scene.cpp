// SPDX-License-Identifier: MIT
#include "bench/bench_scene.h"

#include <map>
#include <memory>

#include "host_sim/io/obj_reader.h"

namespace fixrad::host {

std::string bench_scene_path(const std::string& name) {
  return std::string(FIXRAD_SOURCE_DIR) + "/scenes/" + name + ".obj";
}

const BenchScene& bench_scene(const std::string& name) {
  static std::map<std::string, std::unique_ptr<BenchScene>> scenes;
  std::unique_ptr<BenchScene>& scene = scenes[name];
  if (!scene) {
    scene = std::make_unique<BenchScene>();
    scene->model = read_obj(bench_scene_path(name));
    scene->prepared = prepare(scene->model);
  }
  return *scene;
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host_sim/bake/bake.h"
#include "host_sim/io/obj_reader.h"

namespace fixrad::host::testing {

/// A sample scene, read and prepared. PreparedScene points at the model, so it does not move.
struct Sample {
  Model model;
  PreparedScene prepared;
};

inline std::unique_ptr<Sample> sample(const std::string& name, const ReadOptions& options = {}) {
  auto scene = std::make_unique<Sample>();
  scene->model = read_obj(std::string(FIXRAD_SOURCE_DIR) + "/scenes/" + name + ".obj", options);
  scene->prepared = prepare(scene->model);
  return scene;
}

inline BakeOptions on_profile(const std::string& profile) {
  BakeOptions options;
  options.profile = profile;
  return options;
}

}  // namespace fixrad::host::testing

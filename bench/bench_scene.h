// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host_sim/bake/bake.h"
#include "host_sim/io/model.h"

namespace fixrad::host {

/// A sample scene, read and prepared. PreparedScene points at the model, so it does not move.
struct BenchScene {
  Model model;
  PreparedScene prepared;
};

/// scenes/NAME.obj, read at its first use. Throws InputError.
const BenchScene& bench_scene(const std::string& name);

/// Path of scenes/NAME.obj.
std::string bench_scene_path(const std::string& name);

}  // namespace fixrad::host

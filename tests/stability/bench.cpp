// SPDX-License-Identifier: MIT
#include "tests/stability/bench.h"

#include "host_sim/simulate/convergence.h"
#include "host_sim/simulate/eye_sights.h"
#include "host_sim/simulate/sealed_bodies.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kPiercing =
    24;  // spans beyond twice the faces, for bodies that run through each other

Sizes roomy(const DeviceScene& device, const RandomScene& scene, const Settings& settings) {
  Sizes sizes =
      sizes_for(device, 2 * static_cast<std::uint32_t>(device.faces.size()) + 1 + kPiercing, settings);
  const bool has_pixels = scene.hemisphere == RandomScene::Hemisphere::pixels;
  sizes.pixel_resolution = has_pixels ? static_cast<std::uint32_t>(scene.rows) : 0;
  return sizes;
}

DeviceScene device_of(const Model& model, const RandomScene& scene, const Settings& settings) {
  const PreparedScene prepared = prepare(model);
  DeviceScene device =
      make_device_scene(prepared, make_uniform(prepared, scene.elements, scene.elements / 4));
  if (scene.knows_sights) {
    find_sights(device, roomy(device, scene, settings));
    seal_bodies(device, roomy(device, scene, settings));
  }
  return device;
}

}  // namespace

Settings settings_of(const RandomScene& scene) {
  constexpr std::uint32_t kParts = 200;
  const bool is_lunes = scene.hemisphere == RandomScene::Hemisphere::lunes;
  Settings settings = is_lunes ? lune_settings(scene.rows, fraction(1, kParts))
                               : settings_with(scene.rows, fraction(1, kParts));
  if (scene.hemisphere == RandomScene::Hemisphere::pixels) {
    settings.engine = hemicube_pixels;
  }
  settings.flux_per_row = fraction(1, 1000);
  settings.overshoot = scene.overshoot;
  return settings;
}

Bench::Bench(Model model, const RandomScene& scene, const Settings& settings)
    : model_(std::move(model)),
      device_(device_of(model_, scene, settings)),
      solver_(roomy(device_, scene, settings)),
      status_(solver_.load(device_.view(), settings)) {}

Status Bench::load(const DeviceScene& device, const Settings& settings) {
  status_ = solver_.load(device.view(), settings);
  return status_;
}

bool Bench::run() {
  while (status_ == Status::ok && state().shots < kMostShots) {
    status_ = shoot(state());
  }
  return status_ == Status::converged;
}

std::vector<std::int32_t> Bench::received() const {
  return received_flux_of(solver_.state());
}

}  // namespace fixrad::host

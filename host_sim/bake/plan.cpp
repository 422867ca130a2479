// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "host_sim/bake/bake.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kMostElements = 60000;  // the core numbers them in 16 bits
constexpr std::uint32_t kPiercing = 8;  // spans beyond twice the faces, for faces that pierce each other

// Elements that a profile's accuracy needs: its own number, and several a face where there are many faces.
std::uint32_t default_elements(const Profile& profile, std::uint32_t faces) {
  return std::min(kMostElements, std::max(profile.elements, faces * 10u));
}

// Elements shoot in patches of about so many once each has little left to send.
constexpr std::uint32_t kElementsOfPatch = 4;

BakePlan plan_for(const PreparedScene& scene, const BakeOptions& options, const Profile& profile,
                  std::uint32_t elements) {
  const auto faces = static_cast<std::uint32_t>(scene.faces.size());
  const bool is_gathering = options.solver == "gathering";
  BakePlan plan;
  plan.profile = profile;
  plan.resolution = options.resolution.value_or(options.engine == "lunes" ? profile.lunes : profile.hemicube);
  plan.meshing = make_uniform(scene, elements, elements / kElementsOfPatch);
  const auto channels = static_cast<std::uint32_t>(scene.channels);
  const std::uint32_t n = plan.meshing.element_count;
  plan.sizes = {static_cast<std::uint32_t>(scene.vertices.positions.size()),
                faces,
                n,
                std::min(65535u, 2 * faces + 1 + kPiercing),
                channels,
                options.engine == "pixels" ? static_cast<std::uint32_t>(plan.resolution) : 0u};
  plan.matrix_bytes = is_gathering ? n * n * 2 + n * (2 + 4 * channels) : 0;
  plan.overshoot = options.overshoot;
  return plan;
}

std::string does_not_fit(const PreparedScene& scene, const BakePlan& plan) {
  return scene.model->path + ": error: the scene does not fit profile " + plan.profile.name +
         ": with one element on each of its " + std::to_string(plan.sizes.faces) + " faces it needs " +
         std::to_string(plan.ram()) + " bytes of " + std::to_string(plan.profile.ram_bytes) +
         "; use a larger --profile or a simpler scene";
}

}  // namespace

BakePlan make_plan(const PreparedScene& scene, const BakeOptions& options) {
  const Profile profile = find_profile(options.profile).value();
  const auto faces = static_cast<std::uint32_t>(scene.faces.size());
  std::uint32_t elements =
      std::min(kMostElements, options.elements.value_or(default_elements(profile, faces)));
  for (;;) {
    BakePlan plan = plan_for(scene, options, profile, elements);
    if (options.elements && plan.sizes.elements > std::max(elements, faces)) {
      throw InputError(scene.model->path + ": error: more elements than faces are needed; raise --elements");
    }
    if (plan.sizes.elements > kMostElements) {
      throw InputError(scene.model->path + ": error: the scene has more than " +
                       std::to_string(kMostElements) + " faces; simplify it");
    }
    if (plan.ram() <= profile.ram_bytes) {
      return plan;
    }
    if (elements <= faces || plan.sizes.elements <= faces) {
      throw InputError(does_not_fit(scene, plan));
    }
    elements = std::max(faces, std::min(elements, plan.sizes.elements) * 9 / 10);
  }
}

Settings make_settings(const BakeOptions& options, const BakePlan& plan) {
  const auto to_fraction = [](double a) {
    return Fraction::from_raw(static_cast<std::uint32_t>(std::clamp(std::ldexp(a, 32), 0.0, 4294967295.0)));
  };
  Settings settings;
  if (options.engine == "lunes") {
    const DeltaTable* finest = lune_table(plan.resolution);
    settings.tables = kLunes;
    settings.table_count = static_cast<std::uint8_t>(finest - settings.tables + 1);
  } else {
    settings.engine = options.engine == "pixels" ? hemicube_pixels : hemicube_rows;
    settings.tables = delta_table(plan.resolution);
    settings.table_count = 1;
    settings.probe = &kDelta8;
  }
  settings.stop = to_fraction(options.unshot);
  settings.flux_per_row =
      to_fraction(options.flux_per_row.value_or(plan.profile.flux_of_rows / plan.sizes.elements));
  settings.flux_per_eye = to_fraction(options.flux_per_eye.value_or(plan.profile.flux_per_eye));
  settings.overshoot = plan.overshoot;
  return settings;
}

}  // namespace fixrad::host

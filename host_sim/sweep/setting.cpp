// SPDX-License-Identifier: MIT
#include "host_sim/sweep/setting.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

// Empty optionals where the list is empty.
template <typename T>
std::vector<std::optional<T>> optional_values(const std::vector<T>& values) {
  std::vector<std::optional<T>> all(values.begin(), values.end());
  return all.empty() ? std::vector<std::optional<T>>{std::nullopt} : all;
}

std::vector<BakeOptions> combinations(const BakeOptions& base, const Choices& choices) {
  std::vector<BakeOptions> all;
  for (const std::string& profile : choices.profiles) {
    for (const std::string& engine : choices.engines) {
      for (const std::optional<int>& resolution : optional_values(choices.resolutions)) {
        for (const std::optional<std::uint32_t>& elements : optional_values(choices.elements)) {
          for (const double flux_per_eye : choices.flux_per_eye) {
            BakeOptions options = base;
            options.profile = profile;
            options.engine = engine;
            options.resolution = resolution;
            options.elements = elements;
            options.flux_per_eye = flux_per_eye;
            all.push_back(options);
          }
        }
      }
    }
  }
  return all;
}

// The search for a mesh that fits is long where none does, so the least that any mesh needs is asked first.
bool can_fit(const PreparedScene& scene, const BakeOptions& options) {
  const auto faces = static_cast<std::uint32_t>(scene.faces.size());
  const Profile profile = find_profile(options.profile).value();
  const std::uint32_t buffer = options.engine == "pixels"
                                   ? static_cast<std::uint32_t>(options.resolution.value_or(profile.hemicube))
                                   : 0;
  const Sizes least = {static_cast<std::uint32_t>(scene.vertices.positions.size()),
                       faces,
                       faces,
                       1,
                       std::min(65535u, 2 * faces),
                       static_cast<std::uint32_t>(scene.channels),
                       buffer};
  return ram_bytes(profile, least) <= profile.ram_bytes;
}

std::optional<BakePlan> plan_if_it_fits(const PreparedScene& scene, const BakeOptions& options) {
  if (!can_fit(scene, options)) {
    return std::nullopt;
  }
  try {
    return make_plan(scene, options);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

const std::vector<std::string>& swept_engines() {
  static const std::vector<std::string> engines = {"lunes", "rows", "pixels"};
  return engines;
}

std::vector<BakeOptions> all_settings(const PreparedScene& scene, const BakeOptions& base,
                                      const Choices& choices) {
  std::vector<BakeOptions> settings;
  std::set<std::tuple<std::string, std::string, int, std::uint32_t, std::uint32_t, double>> seen;
  std::map<std::tuple<std::string, std::string, int, std::uint32_t>, std::optional<BakePlan>> plans;
  for (const BakeOptions& options : combinations(base, choices)) {
    // R is part of the memory only where there is an item buffer.
    const int buffer = options.engine == "pixels" ? options.resolution.value_or(0) : 0;
    const auto key = std::make_tuple(options.profile, options.engine, buffer, options.elements.value_or(0));
    if (plans.count(key) == 0) {
      plans[key] = plan_if_it_fits(scene, options);
    }
    const std::optional<BakePlan>& plan = plans[key];
    if (plan && seen.insert({options.profile, options.engine, options.resolution.value_or(0),
                             plan->sizes.elements, plan->sizes.patches, options.flux_per_eye})
                    .second) {
      settings.push_back(options);
    }
  }
  return settings;
}

std::string bake_options_text(const BakeOptions& options, const BakePlan& plan) {
  std::string text = "--profile " + options.profile + " --engine " + options.engine;
  text += " --resolution " + std::to_string(plan.resolution);
  if (options.elements) {
    text += " --elements " + std::to_string(*options.elements);
  }
  text += " --flux-per-eye ";
  append_number(text, options.flux_per_eye);
  const BakeOptions defaults;
  if (options.unshot != defaults.unshot) {
    text += " --unshot ";
    append_number(text, options.unshot);
  }
  if (options.overshoot != defaults.overshoot) {
    text += options.overshoot ? " --overshoot" : " --no-overshoot";
  }
  return text + (options.ambient ? " --ambient" : "");
}

std::string shell_word(const std::string& word) {
  const std::string plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
    return word;
  }
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

}  // namespace fixrad::host

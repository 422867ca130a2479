// SPDX-License-Identifier: MIT
#include "host_sim/sweep/setting.h"

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

}  // namespace

const std::vector<std::string>& swept_engines() {
  static const std::vector<std::string> engines = {"lunes", "rows", "pixels"};
  return engines;
}

std::vector<BakeOptions> all_settings(const PreparedScene& scene, const BakeOptions& base,
                                      const Choices& choices) {
  std::vector<BakeOptions> settings;
  std::set<std::tuple<std::string, std::string, int, std::uint32_t, std::uint32_t, std::uint32_t, double>>
      seen;
  for (const BakeOptions& options : combinations(base, choices)) {
    try {
      const BakePlan plan = make_plan(scene, options);
      if (seen.insert({options.profile, options.engine, plan.resolution, plan.sizes.elements,
                       plan.meshing.patch_count, plan.sizes.patches, options.flux_per_eye})
              .second) {
        settings.push_back(options);
      }
    } catch (const InputError&) {  // does not fit this profile
      continue;
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

// SPDX-License-Identifier: MIT
#include "host_sim/sweep/setting.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kMostRayElements = 1000;

// Empty optionals where the list is empty.
template <typename T>
std::vector<std::optional<T>> optional_values(const std::vector<T>& values) {
  std::vector<std::optional<T>> all(values.begin(), values.end());
  return all.empty() ? std::vector<std::optional<T>>{std::nullopt} : all;
}

std::vector<std::optional<int>> resolutions_of(const std::string& engine, const Choices& choices) {
  const std::vector<int>& own = default_resolutions(engine);
  if (own.empty()) {
    return {std::nullopt};
  }
  std::vector<std::optional<int>> all;
  for (const int resolution : choices.resolutions.empty() ? own : choices.resolutions) {
    if (has_resolution(engine, resolution)) {
      all.emplace_back(resolution);
    }
  }
  return all;
}

// Those that need a plan of their own.
std::vector<BakeOptions> plannable(const BakeOptions& base, const Choices& choices) {
  std::vector<BakeOptions> all;
  for (const std::string& profile : choices.profiles) {
    for (const std::string& engine : choices.engines) {
      for (const std::optional<int>& resolution : resolutions_of(engine, choices)) {
        for (const std::optional<std::uint32_t>& elements : optional_values(choices.elements)) {
          BakeOptions options = base;
          options.profile = profile;
          options.engine = engine;
          options.resolution = resolution;
          options.elements = elements;
          all.push_back(options);
        }
      }
    }
  }
  return all;
}

std::vector<double> row_fluxes(const BakeOptions& options, const BakePlan& plan, const Choices& choices) {
  if (!choices.flux_per_row.empty()) {
    return choices.flux_per_row;
  }
  std::vector<double> all;
  for (const double factor : default_row_factors(options.engine)) {
    all.push_back(short_value(factor * flux_per_row(options, plan)));
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
  static const std::vector<std::string> engines = {"lunes", "rows", "pixels", "rays", "contour"};
  return engines;
}

const std::vector<int>& default_resolutions(const std::string& engine) {
  static const std::vector<int> lunes = {16, 64}, hemicube = {16, 32, 64}, rays = {4, 8, 16}, none;
  return engine == "lunes" ? lunes : engine == "rays" ? rays : engine == "contour" ? none : hemicube;
}

const std::vector<double>& default_row_factors(const std::string& engine) {
  static const std::vector<double> lunes = {4, 2, 1, 0.5, 0.25}, others = {2, 0.5};
  return engine == "lunes" ? lunes : others;
}

double flux_per_row(const BakeOptions& options, const BakePlan& plan) {
  return options.flux_per_row.value_or(plan.profile.flux_of_rows / plan.sizes.elements);
}

double flux_per_eye(const BakeOptions& options, const BakePlan& plan) {
  return options.flux_per_eye.value_or(plan.profile.flux_per_eye);
}

double short_value(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(3) << value;
  double rounded = 0;
  std::istringstream read(text.str());
  read.imbue(std::locale::classic());
  read >> rounded;
  return rounded;
}

std::vector<BakeOptions> all_settings(const PreparedScene& scene, const BakeOptions& base,
                                      const Choices& choices) {
  std::vector<BakeOptions> settings;
  std::set<std::tuple<std::string, std::string, int, std::uint32_t, double, double>> seen;
  std::map<std::tuple<std::string, std::string, int, std::uint32_t>, std::optional<BakePlan>> plans;
  for (BakeOptions options : plannable(base, choices)) {
    // R is part of the memory only where there is an item buffer.
    const int buffer = options.engine == "pixels" ? options.resolution.value_or(0) : 0;
    const auto key = std::make_tuple(options.profile, options.engine, buffer, options.elements.value_or(0));
    if (plans.count(key) == 0) {
      plans[key] = plan_if_it_fits(scene, options);
    }
    const std::optional<BakePlan>& plan = plans[key];
    if (!plan ||
        (choices.leaves_out_slow && options.engine == "rays" && plan->sizes.elements > kMostRayElements)) {
      continue;
    }
    for (const double row_flux : row_fluxes(options, *plan, choices)) {
      for (const std::optional<double>& eye_flux : optional_values(choices.flux_per_eye)) {
        options.flux_per_row = row_flux;
        options.flux_per_eye = eye_flux;
        if (seen.insert({options.profile, options.engine, options.resolution.value_or(0),
                         plan->sizes.elements, row_flux, eye_flux.value_or(0)})
                .second) {
          settings.push_back(options);
        }
      }
    }
  }
  return settings;
}

std::string bake_options_text(const BakeOptions& options, const BakePlan& plan) {
  std::string text = "--profile " + options.profile + " --engine " + options.engine;
  if (!default_resolutions(options.engine).empty()) {
    text += " --resolution " + std::to_string(plan.resolution);
  }
  if (options.elements) {
    text += " --elements " + std::to_string(*options.elements);
  }
  const auto append_flux = [&text](const char* option, const std::optional<double>& flux) {
    if (flux) {
      text += option;
      append_number(text, *flux);
    }
  };
  append_flux(" --flux-per-row ", options.flux_per_row);
  append_flux(" --flux-per-eye ", options.flux_per_eye);
  const BakeOptions defaults;
  if (options.unshot != defaults.unshot) {
    text += " --unshot ";
    append_number(text, options.unshot);
  }
  if (options.overshoot != defaults.overshoot) {
    text += options.overshoot ? " --overshoot" : " --no-overshoot";
  }
  text += options.near_field ? " --near-field" : "";
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

// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdio>
#include <glm/exponential.hpp>
#include <nlohmann/json.hpp>

#include "host_sim/cli/session.h"
#include "host_sim/reference/error_budget.h"
#include "host_sim/reference/form_factors.h"
#include "host_sim/reference/path_tracer.h"
#include "host_sim/reference/radiosity.h"
#include "host_sim/reference/twin.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kPaths = 4000000;      // of the truth, shared among the elements
constexpr std::uint32_t kTruthElements = 400;  // only where paths start; the traced geometry is exact

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Truth {
  std::vector<glm::dvec3> means;  // [input faces]
  double standard_error = 0;      // mean, relative as FaceMeanError::mean
  double seconds = 0;
};

// Elements are independent, so the variances of a face's elements add up; the result is relative as
// FaceMeanError::mean.
double mean_standard_error(const Model& model, const std::vector<Overlap>& overlaps,
                           const std::vector<glm::dvec3>& errors, const std::vector<glm::dvec3>& means,
                           const std::vector<double>& areas, const std::vector<bool>& emits) {
  std::vector<glm::dvec3> variance(model.faces.size(), glm::dvec3(0.0));
  for (const Overlap& o : overlaps) {
    const glm::dvec3 part = o.area / areas[o.input_face] * errors[o.element];
    variance[o.input_face] += part * part;
  }
  for (std::size_t f = 0; f < variance.size(); ++f) {
    variance[f] = means[f] + glm::sqrt(variance[f]);
  }
  return compare_face_means(variance, means, areas, emits).mean;
}

Truth trace_truth(const LoadedScene& scene, const std::vector<double>& areas,
                  const std::vector<bool>& emits) {
  const auto start = std::chrono::steady_clock::now();
  const DeviceScene device =
      make_device_scene(scene.prepared, make_uniform(scene.prepared, kTruthElements, kTruthElements));
  PathTracingOptions options;
  options.paths_per_element = std::max(64u, kPaths / static_cast<std::uint32_t>(device.elements.size()));
  const PathTracedRadiosity traced = path_traced_radiosity(device.mesh, options);
  Truth truth;
  truth.means = face_means(scene.model, device.overlaps, traced.mean);
  truth.standard_error =
      mean_standard_error(scene.model, device.overlaps, traced.standard_error, truth.means, areas, emits);
  truth.seconds = seconds_since(start);
  return truth;
}

struct Line {
  const char* name;
  const char* what;
  double mean, worst, seconds;
};

void print(const LoadedScene& scene, const BakeResult& result, const Truth& truth,
           const std::vector<Line>& lines) {
  std::printf("error budget of %s, profile %s, %u elements, R = %d, %.3g %% unshot\n",
              scene.model.path.c_str(), result.plan.profile.name.c_str(), result.plan.sizes.elements,
              result.plan.resolution, 100 * result.unshot_fraction);
  std::printf("  %-13s %-64s %8s %8s %9s\n", "error", "of what against what", "mean %", "worst %", "seconds");
  for (const Line& line : lines) {
    std::printf("  %-13s %-64s %8.3f %8.2f %9.3f\n", line.name, line.what, 100 * line.mean, 100 * line.worst,
                line.seconds);
  }
  std::printf(
      "  arithmetic: element radiosity over the scene's mean. Others: means of faces that do not emit, "
      "weighted by area;\n");
  std::printf(
      "  worst: of the faces with at least a tenth of the mean radiosity. Truth: path traced, standard error "
      "%.3f %%.\n",
      100 * truth.standard_error);
}

nlohmann::ordered_json to_json(const BakeResult& result, const Truth& truth, const std::vector<Line>& lines) {
  nlohmann::ordered_json json = {{"profile", result.plan.profile.name},
                                 {"resolution", result.plan.resolution},
                                 {"elements", result.plan.sizes.elements},
                                 {"truth_standard_error", truth.standard_error}};
  for (const Line& line : lines) {
    json["errors"].push_back({{"name", line.name},
                              {"what", line.what},
                              {"mean", line.mean},
                              {"worst", line.worst},
                              {"seconds", line.seconds}});
  }
  return json;
}

}  // namespace

int run_compare(const CommonOptions& options) {
  if (options.bake.solver == "gathering") {
    throw InputError("fixrad: error: compare replays shots; leave out --solver gathering");
  }
  check_folder(options.json);
  const auto scene = load_scene(options);
  const Model& model = scene->model;
  std::unique_ptr<Recorder> recorder;
  const auto start_recorder = [&](const State& state) {
    recorder = std::make_unique<Recorder>(state);
    return recorder->observer();
  };
  BakeResult result;
  {
    ProgressBar bar(options);
    const auto progress = [&](std::uint32_t shots, double unshot, double s) {
      return bar.update(shots, unshot, s);
    };
    result = bake(scene->prepared, options.bake, progress, start_recorder);
  }
  if (result.interrupted) {
    say(options, "interrupted: nothing to compare");
    return kInterrupted;
  }
  exit_on_interrupt();
  const DeviceScene& device = result.device;
  auto start = std::chrono::steady_clock::now();
  Twin twin(device.view(), make_settings(options.bake, result.plan));
  twin.replay(*recorder);
  const double twin_seconds = seconds_since(start);
  const std::vector<glm::dvec3> twin_radiosity =
      twin.element_radiosity(device.unit_watts, 1 / (8 * device.grid.scale * device.grid.scale));
  std::vector<double> element_areas;
  for (const MeshElement& e : device.mesh.elements) {
    element_areas.push_back(e.area);
  }
  const ArithmeticError arithmetic =
      compare_arithmetic(result.element_radiosity, twin_radiosity, element_areas);

  start = std::chrono::steady_clock::now();
  const std::vector<glm::dvec3> reference = solve_radiosity(device.mesh, form_factors(device.mesh));
  const double reference_seconds = seconds_since(start);

  const std::vector<double> areas = face_areas(model);
  std::vector<bool> emits;
  for (const Face& face : model.faces) {
    emits.push_back(model.materials[face.material].emission != glm::dvec3(0.0));
  }
  const Truth truth = trace_truth(*scene, areas, emits);
  const auto means = [&](const std::vector<glm::dvec3>& b) { return face_means(model, device.overlaps, b); };
  const FaceMeanError factors = compare_face_means(means(twin_radiosity), means(reference), areas, emits);
  const FaceMeanError mesh = compare_face_means(means(reference), truth.means, areas, emits);
  const FaceMeanError total = compare_face_means(means(result.element_radiosity), truth.means, areas, emits);
  const std::vector<Line> lines = {
      {"arithmetic", "fixed point / the same shots in double", arithmetic.mean, arithmetic.max, twin_seconds},
      {"form factors", "those shots in double / accurate form factors, same mesh", factors.mean,
       factors.worst, reference_seconds},
      {"mesh", "accurate form factors on this mesh / truth", mesh.mean, mesh.worst, truth.seconds},
      {"total", "fixed point / truth", total.mean, total.worst, result.seconds}};
  catch_interrupt();
  print(*scene, result, truth, lines);
  if (!options.json.empty()) {
    write_text(options.json, to_json(result, truth, lines).dump(2) + "\n");
  }
  return kDone;
}

}  // namespace fixrad::host

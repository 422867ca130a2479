// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/cli/compare_points.h"
#include "host_sim/cli/session.h"
#include "host_sim/reference/error_budget.h"
#include "host_sim/reference/form_factors.h"
#include "host_sim/reference/input_polygons.h"
#include "host_sim/reference/path_tracer.h"
#include "host_sim/reference/radiosity.h"
#include "host_sim/reference/refined_radiosity.h"
#include "host_sim/reference/twin.h"
#include "host_sim/report/text.h"
#include "host_sim/simulate/convergence.h"

namespace fixrad::host {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Truth {
  std::vector<glm::dvec3> means;  // [input faces]
  double standard_error = 0;      // mean, relative as FaceMeanError::mean
  double seconds = 0;
};

struct Line {
  const char* name;
  const char* what;
  FaceMeanError error;
  double seconds;
};

struct Budget {
  std::vector<Line> lines;
  Truth truth;
  RefinedRadiosity refined;
  FaceMeanError references;  // refined mesh against truth
};

// Face means of one scene, to be compared.
class Comparison {
 public:
  explicit Comparison(const Model& model) : areas_(face_areas(model)) {
    for (const Face& face : model.faces) {
      emits_.push_back(model.materials[face.material].emission != glm::dvec3(0.0));
    }
  }

  FaceMeanError operator()(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) const {
    return compare_face_means(a, b, areas_, emits_);
  }

 private:
  std::vector<double> areas_;
  std::vector<bool> emits_;
};

Truth trace_truth(const LoadedScene& scene, const Comparison& compare) {
  const auto start = std::chrono::steady_clock::now();
  Traced traced = path_traced_faces(input_polygons(scene.prepared));
  traced.mean.resize(scene.model.faces.size(), glm::dvec3(0.0));
  traced.standard_error.resize(scene.model.faces.size(), glm::dvec3(0.0));
  Truth truth;
  truth.means = traced.mean;
  for (std::size_t f = 0; f < traced.mean.size(); ++f) {
    traced.mean[f] += traced.standard_error[f];
  }
  truth.standard_error = compare(traced.mean, truth.means).mean;
  truth.seconds = seconds_since(start);
  return truth;
}

// Which face of the file, and what it is made of.
std::string address(const Model& model, std::size_t face) {
  return std::to_string(face % model.file_faces) + " " + model.materials[model.faces[face].material].name;
}

void print(const LoadedScene& scene, const BakeResult& result, const Budget& budget) {
  std::printf("error budget of %s, profile %s, %u elements, R = %d, %.3g %% unshot\n",
              scene.model.path.c_str(), result.plan.profile.name.c_str(), result.plan.sizes.elements,
              result.plan.resolution, 100 * result.unshot_fraction);
  std::printf("  %-13s %-56s %8s %8s %9s  %s\n", "error", "of what against what", "mean %", "worst %",
              "seconds", "worst face");
  for (const Line& line : budget.lines) {
    std::printf("  %-13s %-56s %8.3f %8.2f %9.3f  %s\n", line.name, line.what, 100 * line.error.mean,
                100 * line.error.worst, line.seconds, address(scene.model, line.error.worst_face).c_str());
  }
  std::printf(
      "  arithmetic: element radiosity over the scene's mean. Others: means of faces that do not emit, "
      "weighted by area;\n"
      "  worst: of the faces with at least a tenth of the mean radiosity; faces count from 0. Seconds: the "
      "shots "
      "in double,\n  the form factors, all refined meshes, the fixed-point core.\n");
  const RefinedRadiosity& refined = budget.refined;
  std::printf("  Refined mesh: %u elements, cut where faces touch; the last doubling moved face means by ",
              refined.elements);
  if (std::isfinite(refined.change)) {
    std::printf("%.3f %%%s.\n", 100 * refined.change, refined.settled ? "" : ", not settled yet");
  } else {
    std::printf("nobody knows: one mesh was all that fitted.\n");
  }
  std::printf(
      "  Truth: path traced in %.3f s, standard error %.3f %%; the refined mesh is %.3f %% from it.\n",
      budget.truth.seconds, 100 * budget.truth.standard_error, 100 * budget.references.mean);
}

nlohmann::ordered_json plan_json(const BakeResult& result) {
  return {{"profile", result.plan.profile.name},
          {"resolution", result.plan.resolution},
          {"elements", result.plan.sizes.elements}};
}

nlohmann::ordered_json to_json(const Model& model, const Budget& budget) {
  const RefinedRadiosity& refined = budget.refined;
  nlohmann::ordered_json json = {{"truth_standard_error", budget.truth.standard_error},
                                 {"truth_seconds", budget.truth.seconds}};
  for (const Line& line : budget.lines) {
    const std::size_t face = line.error.worst_face;
    json["errors"].push_back({{"name", line.name},
                              {"what", line.what},
                              {"mean", line.error.mean},
                              {"worst", line.error.worst},
                              {"worst_face", face % model.file_faces},
                              {"worst_material", model.materials[model.faces[face].material].name},
                              {"seconds", line.seconds}});
  }
  json["refined"] = {{"elements", refined.elements},
                     {"settled", refined.settled},
                     {"against_truth", budget.references.mean}};
  json["refined"]["change"] =
      std::isfinite(refined.change) ? nlohmann::json(refined.change) : nlohmann::json();
  return json;
}

// The core's run and its twin's, first line of the budget.
FaceMeanError arithmetic_error(const BakeResult& result, const std::vector<glm::dvec3>& twin_radiosity) {
  std::vector<double> areas;
  for (const MeshElement& e : result.device.mesh.elements) {
    areas.push_back(e.area);
  }
  const ArithmeticError error = compare_arithmetic(result.element_radiosity, twin_radiosity, areas);
  return {error.mean, error.max, result.device.mesh.elements[error.worst_element].input_face};
}

// How far one channel is from its converged solution; fluxes over all that elements receive in the end.
struct Convergence {
  double unshot, largest_reflectance, bound, distance;
};

// The converged solution has this part of the unshot flux at most.
constexpr double kConverged = 0.001;

// Solves once more, to the same state, and on from there.
std::vector<Convergence> measure_convergence(const CommonOptions& options, const BakeResult& result) {
  SimulatedDevice device(result.plan.sizes);
  const Settings settings = make_settings(options.bake, result.plan);
  if (device.load(result.device.view(), settings) != Status::ok) {
    return {};
  }
  State& state = device.state();
  while (shoot(state) == Status::ok) {
  }
  const std::vector<ErrorBound> bounds = error_bounds(state);
  const std::vector<std::int32_t> stopped = received_flux_of(state);
  shoot_on(state, Fraction::from_raw(static_cast<std::uint32_t>(kConverged * settings.stop.raw)));
  const std::vector<std::int32_t> converged = received_flux_of(state);
  std::vector<Convergence> channels;
  for (int c = 0; c < state.scene.channels; ++c) {
    const ErrorBound& bound = bounds[static_cast<std::size_t>(c)];
    const FluxDistance flux = flux_distance(stopped, converged, c, state.scene.channels);
    const double total = std::max(1.0, flux.total);
    channels.push_back(
        {bound.unshot / total, bound.largest_reflectance, bound.flux / total, flux.distance / total});
  }
  return channels;
}

void print(const std::vector<Convergence>& channels) {
  constexpr const char* kNames[] = {"red", "green", "blue"};
  std::printf("  Convergence, flux received by all elements:");
  for (std::size_t c = 0; c < channels.size(); ++c) {
    std::printf("%s %s unshot %.4f %%, error bound %.4f %%, distance to the converged solution %.4f %%",
                c == 0 ? "" : ";\n   ", channels.size() == 1 ? "all channels" : kNames[c],
                100 * channels[c].unshot, 100 * channels[c].bound, 100 * channels[c].distance);
  }
  std::printf(".\n");
}

nlohmann::ordered_json to_json(const std::vector<Convergence>& channels) {
  nlohmann::ordered_json json;
  for (const Convergence& c : channels) {
    json.push_back({{"unshot", c.unshot},
                    {"largest_reflectance", c.largest_reflectance},
                    {"error_bound", c.bound},
                    {"distance", c.distance}});
  }
  return json;
}

Budget measure(const LoadedScene& scene, const CommonOptions& options, const BakeResult& result,
               const Recorder& recorder) {
  const DeviceScene& device = result.device;
  const Comparison compare(scene.model);
  const auto means = [&](const std::vector<glm::dvec3>& b) {
    return face_means(scene.model, device.overlaps, b);
  };
  auto start = std::chrono::steady_clock::now();
  Twin twin(device.view(), make_settings(options.bake, result.plan));
  twin.replay(recorder);
  const double twin_seconds = seconds_since(start);
  const std::vector<glm::dvec3> twin_radiosity =
      twin.element_radiosity(device.unit_watts, 1 / (8 * device.grid.scale * device.grid.scale));

  start = std::chrono::steady_clock::now();
  const FormFactors factors = form_factors(device.mesh, effort_for(device.mesh.elements.size()));
  const std::vector<glm::dvec3> reference = means(solve_radiosity(device.mesh, factors));
  const double reference_seconds = seconds_since(start);

  Budget budget;
  start = std::chrono::steady_clock::now();
  budget.refined = refined_radiosity(scene.prepared);
  const double refined_seconds = seconds_since(start);
  budget.truth = trace_truth(scene, compare);
  budget.references = compare(budget.refined.face_means, budget.truth.means);
  budget.lines = {{"arithmetic", "fixed point / the same shots in double",
                   arithmetic_error(result, twin_radiosity), twin_seconds},
                  {"form factors", "those shots in double / accurate form factors, same mesh",
                   compare(means(twin_radiosity), reference), reference_seconds},
                  {"mesh", "accurate form factors on this mesh / on a refined mesh",
                   compare(reference, budget.refined.face_means), refined_seconds},
                  {"total", "fixed point / truth",
                   compare(means(result.element_radiosity), budget.truth.means), result.seconds}};
  return budget;
}

}  // namespace

int run_compare(const CommonOptions& options) {
  if (options.bake.solver == "gathering") {
    throw InputError("fixrad: error: compare replays shots; leave out --solver gathering");
  }
  check_folder(options.json);
  check_folder(options.points_truth);
  const auto scene = load_scene(options);
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
  nlohmann::ordered_json json = plan_json(result);
  if (!options.points_only) {
    const Budget budget = measure(*scene, options, result, *recorder);
    print(*scene, result, budget);
    json.update(to_json(scene->model, budget));
    const std::vector<Convergence> convergence = measure_convergence(options, result);
    print(convergence);
    json["convergence"] = to_json(convergence);
  }
  if (options.points > 0) {
    const PointBudget points = measure_points(*scene, options, result);
    print(points);
    json["points"] = to_json(points);
  }
  catch_interrupt();
  if (!options.json.empty()) {
    write_text(options.json, json.dump(2) + "\n");
  }
  return kDone;
}

}  // namespace fixrad::host

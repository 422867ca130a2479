// SPDX-License-Identifier: MIT
// What accuracy costs on the host, one thread: the integer core and the yardstick in double that casts rays,
// both by progressive shooting on the same meshes of the Cornell box; and what one shot of the core costs as
// the mesh grows. scripts/measure_speed.py runs this and writes docs/speed.md.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <functional>

#include "bench/bench_scene.h"
#include "host_sim/meshing/contact_lines.h"
#include "host_sim/reference/error_budget.h"
#include "host_sim/reference/input_polygons.h"
#include "host_sim/reference/path_tracer.h"
#include "host_sim/reference/ray_cast_shooting.h"

namespace fixrad::host {
namespace {

constexpr const char* kScene = "cornell";
constexpr std::uint64_t kTruthPaths = 1U << 24U;
// One mesh proves nothing: figures are means of three of about the same size.
constexpr std::array<double, 3> kMeshes{0.93, 1.0, 1.07};
// The fastest of so many runs counts, but slow runs are steady enough alone.
constexpr int kRepeats = 4;
constexpr double kSlow = 0.5;

struct Outcome {
  double seconds, error, elements, shots;
};

const std::vector<glm::dvec3>& truth() {
  static const std::vector<glm::dvec3> means = [] {
    FaceTracingOptions options;
    options.paths = kTruthPaths;
    return path_traced_faces(input_polygons(bench_scene(kScene).prepared), options).mean;
  }();
  return means;
}

double error_of(const std::vector<Overlap>& overlaps, const std::vector<glm::dvec3>& radiosity) {
  const Model& model = bench_scene(kScene).model;
  std::vector<bool> emits;
  for (const Face& face : model.faces) {
    emits.push_back(model.materials[face.material].emission != glm::dvec3(0.0));
  }
  return compare_face_means(face_means(model, overlaps, radiosity), truth(), face_areas(model), emits).mean;
}

Outcome run_core(std::uint32_t elements, int resolution) {
  BakeOptions options;
  options.profile = "host";
  options.elements = elements;
  options.resolution = resolution;
  const BakeResult result = bake(bench_scene(kScene).prepared, options);
  return {result.seconds, error_of(result.device.overlaps, result.element_radiosity),
          static_cast<double>(result.plan.sizes.elements), static_cast<double>(result.shots)};
}

// `cut`: on the mesh cut where faces touch (the core's --mesh contacts) instead of on the core's uniform one.
Outcome run_rays(std::uint32_t elements, std::uint32_t rays, bool cut, bool keep_pairs) {
  const PreparedScene& scene = bench_scene(kScene).prepared;
  Meshing meshing = make_uniform(scene, elements, elements);
  if (cut) {
    cut_at_contacts(scene, meshing);
  }
  const DeviceScene device = make_device_scene(scene, meshing);
  RayCastOptions options;
  options.rays = rays;
  options.keep_pairs = keep_pairs;
  const RayCastResult result = ray_cast_shooting(device.mesh, options);
  return {result.seconds, error_of(device.overlaps, result.radiosity),
          static_cast<double>(device.mesh.elements.size()), static_cast<double>(result.shots)};
}

// Runs on three meshes about `elements` large and reports means.
void report(benchmark::State& state, double elements, const std::function<Outcome(std::uint32_t)>& run) {
  Outcome mean = {0, 0, 0, 0};
  for (auto _ : state) {
    for (const double factor : kMeshes) {
      const auto size = static_cast<std::uint32_t>(factor * elements);
      Outcome best = run(size);
      for (int k = 1; k < kRepeats && best.seconds < kSlow; ++k) {
        best.seconds = std::min(best.seconds, run(size).seconds);
      }
      constexpr double kPart = 1.0 / kMeshes.size();
      mean.seconds += kPart * best.seconds;
      mean.error += kPart * best.error;
      mean.elements += kPart * best.elements;
      mean.shots += kPart * best.shots;
    }
    state.SetIterationTime(mean.seconds);
  }
  state.counters["error_percent"] = 100 * mean.error;
  state.counters["elements"] = mean.elements;
  state.counters["shots"] = mean.shots;
}

void BM_CornellByCore(benchmark::State& state) {
  report(state, static_cast<double>(state.range(0)),
         [&](std::uint32_t elements) { return run_core(elements, static_cast<int>(state.range(1))); });
}

void rays(benchmark::State& state, bool keep_pairs) {
  report(state, static_cast<double>(state.range(0)), [&](std::uint32_t elements) {
    return run_rays(elements, static_cast<std::uint32_t>(state.range(1)), state.range(2) != 0, keep_pairs);
  });
}

void BM_CornellByRays(benchmark::State& state) {
  rays(state, false);
}

void BM_CornellByRaysKept(benchmark::State& state) {
  rays(state, true);
}

// Profile host: R as it chooses, from 200 to 3200 elements.
void BM_ShotOfHostProfile(benchmark::State& state) {
  BakeOptions options;
  options.profile = "host";
  options.elements = static_cast<std::uint32_t>(state.range(0));
  BakeResult result;
  double best = 0;
  for (auto _ : state) {
    for (int k = 0; k < kRepeats && (k == 0 || best < kSlow); ++k) {
      result = bake(bench_scene(kScene).prepared, options);
      best = k == 0 ? result.seconds : std::min(best, result.seconds);
    }
    state.SetIterationTime(best / result.shots);
  }
  state.counters["elements"] = result.plan.sizes.elements;
  state.counters["resolution"] = result.plan.resolution;
  state.counters["shots"] = result.shots;
  state.counters["eyes"] = result.eyes;
  state.counters["us_per_eye"] = 1e6 * best / result.eyes;
}

const std::vector<std::int64_t> kSizes{100, 180, 330, 600, 1100, 2000};

BENCHMARK(BM_CornellByCore)
    ->ArgsProduct({kSizes, {8, 16, 32, 64}})
    ->ArgNames({"elements", "R"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(BM_CornellByRays)
    ->ArgsProduct({{100, 180, 330, 600, 1100}, {4, 8, 16}, {0, 1}})
    ->ArgNames({"elements", "rays", "cut"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(BM_CornellByRaysKept)
    ->ArgsProduct({kSizes, {4, 8, 16, 32}, {0, 1}})
    ->ArgNames({"elements", "rays", "cut"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(BM_ShotOfHostProfile)
    ->ArgsProduct({{200, 400, 800, 1600, 3200}})
    ->ArgNames({"elements"})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(1);

}  // namespace
}  // namespace fixrad::host

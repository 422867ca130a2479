// SPDX-License-Identifier: MIT
// What comes before the solver, stage by stage, for the largest sample scene.
#include <benchmark/benchmark.h>

#include "bench/bench_scene.h"
#include "host_sim/io/obj_reader.h"

namespace fixrad::host {
namespace {

constexpr const char* kScene = "furnished_room";

void BM_ReadObj(benchmark::State& run) {
  const std::string path = bench_scene_path(kScene);
  for (auto _ : run) {
    benchmark::DoNotOptimize(read_obj(path));
  }
}

void BM_Prepare(benchmark::State& run) {
  const Model& model = bench_scene(kScene).model;
  for (auto _ : run) {
    benchmark::DoNotOptimize(prepare(model));
  }
}

void BM_Plan(benchmark::State& run) {
  const PreparedScene& prepared = bench_scene(kScene).prepared;
  for (auto _ : run) {
    benchmark::DoNotOptimize(make_plan(prepared, {}));
  }
}

void BM_DeviceScene(benchmark::State& run) {
  const PreparedScene& prepared = bench_scene(kScene).prepared;
  const BakePlan plan = make_plan(prepared, {});
  for (auto _ : run) {
    benchmark::DoNotOptimize(make_device_scene(prepared, plan.meshing));
  }
}

void BM_SurfaceMesh(benchmark::State& run) {
  const PreparedScene& prepared = bench_scene(kScene).prepared;
  const DeviceScene device = make_device_scene(prepared, make_plan(prepared, {}).meshing);
  for (auto _ : run) {
    benchmark::DoNotOptimize(make_surface_mesh(prepared, device));
  }
}

BENCHMARK(BM_ReadObj)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Prepare)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Plan)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DeviceScene)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SurfaceMesh)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fixrad::host

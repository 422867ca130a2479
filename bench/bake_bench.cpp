// SPDX-License-Identifier: MIT
// Whole solutions: the integer core against its twin in double, rows against pixels. Times are the solver's
// alone, without reading, meshing and output, which both sides share.
#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>

#include "bench/bench_scene.h"
#include "host_sim/reference/twin.h"

namespace fixrad::host {
namespace {

BakeOptions options_of(const char* profile, const char* engine) {
  BakeOptions options;
  options.profile = profile;
  options.engine = engine;
  return options;
}

void bake_scene(benchmark::State& run, const char* scene, const char* profile, const char* engine) {
  const PreparedScene& prepared = bench_scene(scene).prepared;
  BakeResult result;
  double seconds = 0;
  for (auto _ : run) {
    result = bake(prepared, options_of(profile, engine));
    run.SetIterationTime(result.seconds);
    seconds += result.seconds;
  }
  run.counters["elements"] = result.plan.sizes.elements;
  run.counters["shots"] = result.shots;
  run.counters["us_per_eye"] = 1e6 * seconds / static_cast<double>(run.iterations()) / result.eyes;
}

// Replays in double every shot of a fixed-point run made just before, so that both see the same machine. The
// bar: `fixed_over_twin` is at most 1.
void replay_scene(benchmark::State& run, const char* scene, const char* profile) {
  const PreparedScene& prepared = bench_scene(scene).prepared;
  const BakeOptions options = options_of(profile, "rows");
  double fixed_seconds = 0, twin_seconds = 0;
  for (auto _ : run) {
    std::unique_ptr<Recorder> recorder;
    const BakeResult result = bake(prepared, options, {}, [&](const State& state) {
      recorder = std::make_unique<Recorder>(state);
      return recorder->observer();
    });
    Twin twin(result.device.view(), make_settings(options, result.plan));
    const auto start = std::chrono::steady_clock::now();
    twin.replay(*recorder);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.SetIterationTime(seconds);
    fixed_seconds += result.seconds;
    twin_seconds += seconds;
  }
  run.counters["fixed_over_twin"] = fixed_seconds / twin_seconds;
}

void BM_BakeCornellLarge(benchmark::State& run) {
  bake_scene(run, "cornell", "large", "rows");
}
void BM_TwinCornellLarge(benchmark::State& run) {
  replay_scene(run, "cornell", "large");
}
void BM_BakeSmallLampLarge(benchmark::State& run) {
  bake_scene(run, "small_lamp", "large", "rows");
}
void BM_TwinSmallLampLarge(benchmark::State& run) {
  replay_scene(run, "small_lamp", "large");
}
void BM_RowsCornellSmall(benchmark::State& run) {
  bake_scene(run, "cornell", "small", "rows");
}
void BM_PixelsCornellSmall(benchmark::State& run) {
  bake_scene(run, "cornell", "small", "pixels");
}
void BM_RowsCornellMedium(benchmark::State& run) {
  bake_scene(run, "cornell", "medium", "rows");
}
void BM_PixelsCornellMedium(benchmark::State& run) {
  bake_scene(run, "cornell", "medium", "pixels");
}

BENCHMARK(BM_BakeCornellLarge)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(BM_TwinCornellLarge)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(BM_BakeSmallLampLarge)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(BM_TwinSmallLampLarge)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(BM_RowsCornellSmall)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PixelsCornellSmall)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RowsCornellMedium)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PixelsCornellMedium)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fixrad::host

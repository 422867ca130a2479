// SPDX-License-Identifier: MIT
// count_work SCENE OPTIONS...: solves as `fixrad bake` with these options does and prints the digest and the
// steps that the solution took as JSON, for scripts/fit_costs.py.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <memory>

#include "host_sim/cli/options.h"
#include "host_sim/sweep/work.h"

namespace fixrad::host {
namespace {

int run(int argc, char** argv) {
  CLI::App app("Count the steps of a solution", "count_work");
  CommonOptions options;
  add_scene_options(app, options);
  add_solver_options(app, options);
  CLI11_PARSE(app, argc, argv);
  const Model model = read_obj(options.scene, options.read);
  const PreparedScene scene = prepare(model);
  std::unique_ptr<WorkRecorder> recorder;
  const BakeResult result = bake(scene, options.bake, {}, [&](const State& state) {
    recorder = std::make_unique<WorkRecorder>(state);
    return recorder->observer();
  });
  const std::optional<Work> work = count_work(result, options.bake, *recorder);
  if (!work) {
    throw InputError("count_work: error: the steps of engine " + options.bake.engine + " are not known");
  }
  std::printf("{\"digest\": \"%016llx\", \"work\": {", static_cast<unsigned long long>(result.digest));
  for (unsigned i = 0; i < kWorkUnits; ++i) {
    std::printf("%s\"%s\": %llu", i == 0 ? "" : ", ", kWorkNames[i],
                static_cast<unsigned long long>((*work)[i]));
  }
  std::printf("}}\n");
  return kDone;
}

}  // namespace
}  // namespace fixrad::host

int main(int argc, char** argv) {
  try {
    return fixrad::host::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return fixrad::host::kBadInput;
  }
}

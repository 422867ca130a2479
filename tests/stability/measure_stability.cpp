// SPDX-License-Identifier: MIT
// The catalogue of hard cases as JSON, for scripts/measure_stability.py.
//   measure_stability [NAME...]   all cases, or these
//   measure_stability --bounds    how much of the error bound is used, over all moments of some solutions
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/simulate/simulated_device.h"
#include "tests/stability/bound_trial.h"
#include "tests/stability/trial.h"

namespace fixrad::host {
namespace {

nlohmann::ordered_json to_json(const Verdict& verdict) {
  nlohmann::ordered_json json = {
      {"imbalance", verdict.imbalance}, {"escaped", verdict.escaped}, {"back", verdict.back}};
  for (const Finding& finding : verdict.findings) {
    json["findings"].push_back({{"what", finding.what},
                                {"value", finding.value},
                                {"expected", finding.expected},
                                {"bound", finding.bound},
                                {"holds", finding.holds()}});
  }
  return json;
}

nlohmann::ordered_json to_json(const HardCase& hard, const Trial& trial) {
  nlohmann::ordered_json json = {{"name", hard.name},
                                 {"hard", hard.hard},
                                 {"theory", hard.theory},
                                 {"status", describe(trial.status)},
                                 {"shots", trial.shots},
                                 {"imbalance", trial.imbalance},
                                 {"saturated", trial.saturated},
                                 {"rises", trial.rises},
                                 {"overshoots", hard.settings.overshoot},
                                 {"fixed", to_json(trial.fixed)},
                                 {"double", to_json(trial.twin)}};
  if (trial.peer.has_solved || !trial.peer.findings.empty()) {
    json["float"] = to_json(trial.peer);
    json["float"]["ended"] = trial.peer.has_solved;
  }
  return json;
}

nlohmann::ordered_json bounds() {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const BoundScene& scene : bound_scenes()) {
    for (const bool overshoot : {false, true}) {
      SolveOptions options;
      options.elements = 250;
      options.settings = lune_settings(32, fraction(1, 1000));
      options.settings.overshoot = overshoot;
      const BoundTrial trial = try_bound(scene.model, options);
      all.push_back({{"scene", scene.name},
                     {"overshoots", overshoot},
                     {"moments", trial.moments},
                     {"worst", trial.worst},
                     {"last", trial.last}});
    }
  }
  return all;
}

}  // namespace
}  // namespace fixrad::host

int main(int argc, char** argv) {
  using namespace fixrad::host;
  if (argc == 2 && std::string(argv[1]) == "--bounds") {
    std::puts(bounds().dump(1).c_str());
    return 0;
  }
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const HardCase& hard : hard_cases()) {
    if (argc > 1 && std::find(argv + 1, argv + argc, hard.name) == argv + argc) {
      continue;
    }
    std::fprintf(stderr, "%s\n", hard.name.c_str());
    all.push_back(to_json(hard, try_case(hard, {})));
  }
  std::puts(all.dump(1).c_str());
  return all.empty() ? 2 : 0;
}

// SPDX-License-Identifier: MIT
#include "tests/stability/trial.h"

#include <algorithm>
#include <memory>

#include "host_sim/simulate/eye_sights.h"
#include "host_sim/simulate/sealed_bodies.h"
#include "host_sim/simulate/simulated_device.h"
#include "tests/lib/solution.h"
#include "tests/stability/readings.h"

namespace fixrad::host {
namespace {

constexpr int kTablesOfPeer = 4;  // R = 4 to 32

// The peer is still at it after this many times the core's shots: it will not come to its end.
constexpr std::uint64_t kPatience = 4;

// Ledgers are added up after each of the first shots, later now and then: that is as much work as a shot.
bool is_looked_at(std::uint32_t shots) {
  return shots < 1000 || shots % 997 == 0;
}

std::uint64_t unshot_sum(const State& state) {
  std::uint64_t sum = 0;
  for (int c = 0; c < state.scene.channels; ++c) {
    sum += sum_unshot(state, c).magnitude;
  }
  return sum;
}

std::uint32_t saturated(const State& state) {
  std::uint32_t count = 0;
  for (std::uint16_t e = 0; e < state.scene.element_count; ++e) {
    for (int c = 0; c < state.scene.channels; ++c) {
      count += element_radiosity(state, e, c, Radiosity::from_raw(0)).raw == 0xffffffffu ? 1 : 0;
    }
  }
  return count;
}

// What is asked of the core on its way.
class Watch {
 public:
  Watch(const State& state, Trial& trial) : state_(state), trial_(trial), unshot_(unshot_sum(state)) {
    look();
  }

  void after_shot() {
    if (is_looked_at(state_.shots)) {
      look();
    }
  }

  void look() {
    for (int c = 0; c < state_.scene.channels; ++c) {
      trial_.imbalance = std::max(trial_.imbalance, std::abs(ledger(state_, c).imbalance()));
    }
    const std::uint64_t unshot = unshot_sum(state_);
    trial_.rises += unshot > unshot_ ? 1 : 0;
    unshot_ = unshot;
  }

 private:
  const State& state_;
  Trial& trial_;
  std::uint64_t unshot_;
};

// One model and its light in each arithmetic.
struct Run {
  Run(const Model& model, const CaseSettings& wanted)
      : prepared(prepare(model)), device(mesh_case(prepared, wanted)), settings(settings_of(wanted)) {}

  // As many spans as a row of this scene ever shows.
  std::uint32_t spans_used() const {
    SimulatedDevice solver(sizes_for(device, 0, settings));
    Status status = solver.load(device.view(), settings);
    while (status == Status::ok) {
      status = shoot(solver.state());
    }
    return solver.state().work.span_high_water;
  }

  void solve(std::uint32_t spans, bool has_twin, Trial& trial) {
    SimulatedDevice solver(sizes_for(device, spans, settings));
    Recorder recorder(solver.state());
    Settings watched = settings;
    watched.observer = has_twin ? recorder.observer() : Observer{};
    trial.status = solver.load(device.view(), watched);
    if (trial.status != Status::ok) {
      return;
    }
    const auto double_twin = has_twin ? std::make_unique<Twin>(device.view(), watched) : nullptr;
    Watch watch(solver.state(), trial);
    while (trial.status == Status::ok && solver.state().shots < kMostShots) {
      trial.status = shoot(solver.state());
      if (double_twin) {
        double_twin->replay(recorder);
        recorder.forget_shots();
      }
      watch.after_shot();
    }
    watch.look();
    trial.shots += solver.state().shots;
    trial.saturated += saturated(solver.state());
    core = read_core(device, solver.state());
    if (double_twin) {
      twin = read_twin(device, *double_twin);
      trial.twin.imbalance = std::max(trial.twin.imbalance, imbalance_of(*double_twin));
    }
  }

  bool suits_peer() const { return settings.engine == lune_rows && settings.table_count <= kTablesOfPeer; }

  void solve_peer(std::uint64_t most_shots, Trial& trial) {
    PeerSolution solver(device, settings);
    trial.peer_status = Status::ok;
    while (trial.peer_status == Status::ok && solver.solver().shots() < most_shots) {
      trial.peer_status = solver.step();
    }
    peer = read_peer(device, solver);
    trial.peer.imbalance = std::max(trial.peer.imbalance, solver.imbalance());
  }

  PreparedScene prepared;
  DeviceScene device;
  Settings settings;
  Light core, twin, peer;
};

void sum_up(const HardCase& hard, const std::vector<std::unique_ptr<Run>>& runs, Light Run::*light,
            Verdict& verdict) {
  std::vector<Light> lights;
  for (const auto& run : runs) {
    lights.push_back((*run).*light);
    for (std::size_t c = 0; c < 3; ++c) {
      verdict.escaped = std::max(verdict.escaped, lights.back().escaped[c]);
      verdict.back = std::max(verdict.back, lights.back().back[c]);
    }
  }
  verdict.has_solved = true;
  verdict.findings = hard.judge(lights);
}

}  // namespace

const Finding& Verdict::worst() const {
  const auto used = [](const Finding& f) { return f.error() / std::max(f.bound, 1e-12); };
  return *std::max_element(findings.begin(), findings.end(),
                           [&](const Finding& a, const Finding& b) { return used(a) < used(b); });
}

DeviceScene mesh_case(const PreparedScene& prepared, const CaseSettings& settings) {
  Meshing meshing = make_uniform(prepared, settings.elements, settings.elements / 4);
  if (!settings.cells.empty()) {
    meshing.element_count = 0;
    for (std::size_t f = 0; f < meshing.faces.size(); ++f) {
      const auto [u, v] = settings.cells[std::min(f, settings.cells.size() - 1)];
      meshing.faces[f] = cut_face(prepared.frames[f], u, v);
      meshing.element_count += static_cast<std::uint32_t>(meshing.faces[f].elements.size());
    }
  }
  DeviceScene device = make_device_scene(prepared, meshing);
  const Sizes sizes = sizes_for(device, 0, settings_of(settings));
  find_sights(device, sizes);
  seal_bodies(device, sizes);
  return device;
}

Settings settings_of(const CaseSettings& wanted) {
  Settings settings = lune_settings(wanted.lunes, wanted.stop);
  settings.overshoot = wanted.overshoot;
  settings.flux_per_row = wanted.flux_per_row;
  settings.flux_per_eye = wanted.flux_per_eye;
  return settings;
}

Trial try_case(const HardCase& hard, Rivals rivals) {
  Trial trial;
  const std::vector<Model> models = hard.models();
  std::vector<std::unique_ptr<Run>> runs;
  bool is_peer_asked = rivals.peer;
  for (const Model& model : models) {
    runs.push_back(std::make_unique<Run>(model, hard.settings));
    const std::uint32_t spans = hard.settings.spans_to_the_last ? runs.back()->spans_used() : 0;
    runs.back()->solve(spans, rivals.twin, trial);
    if (trial.status != Status::converged) {
      return trial;
    }
    is_peer_asked = is_peer_asked && runs.back()->suits_peer();
    if (is_peer_asked) {
      runs.back()->solve_peer(kPatience * trial.shots, trial);
    }
  }
  sum_up(hard, runs, &Run::core, trial.fixed);
  if (rivals.twin) {
    sum_up(hard, runs, &Run::twin, trial.twin);
  }
  if (is_peer_asked) {
    sum_up(hard, runs, &Run::peer, trial.peer);
    trial.peer.has_solved = trial.peer_status == Status::converged;
  }
  return trial;
}

}  // namespace fixrad::host

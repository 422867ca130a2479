// SPDX-License-Identifier: MIT
#include "host_sim/bake/bake.h"

#include <cmath>

#include "host_sim/bake/clock.h"
#include "host_sim/bake/state_file.h"
#include "host_sim/simulate/eye_sights.h"
#include "host_sim/simulate/sealed_bodies.h"

namespace fixrad::host {
namespace {

constexpr double kReportEvery = 0.05;  // seconds
constexpr int kMostSweeps = 100000;

// Tells the caller how far the solution is, at most every kReportEvery seconds; false: stop.
class Reporter {
 public:
  explicit Reporter(const Progress& progress) : progress_(progress) {}

  bool go_on(const State& state) {
    const double now = clock_.seconds();
    if (!progress_ || now < next_) {
      return true;
    }
    next_ = now + kReportEvery;
    is_stopped_ =
        !progress_(state.shots, std::ldexp(static_cast<double>(unshot_fraction(state).raw), -32), now);
    return !is_stopped_;
  }

  bool is_stopped() const { return is_stopped_; }

 private:
  const Progress& progress_;
  Clock clock_;
  double next_ = kReportEvery;
  bool is_stopped_ = false;
};

// Goes on from a saved state and saves, as the options say.
class Keeper {
 public:
  Keeper(const StateOptions& options, State& state) : options_(options) {
    if (!options.resume.empty() || !options.save.empty()) {
      identity_ = identify(state);
    }
    if (!options.resume.empty()) {
      const StateFile file(options.resume);
      file.resume(state, identity_);
      sequence_ = file.header().sequence + 1;
    }
  }

  // Whether the shots asked for are done.
  bool is_enough(const State& state) const { return options_.shots && state.shots >= *options_.shots; }

  void after_shot(const State& state) {
    if (options_.save_every > 0 && state.shots % options_.save_every == 0) {
      save(state);
    }
  }

  void save(const State& state) {
    if (!options_.save.empty()) {
      write_state(options_.save, state, identity_, sequence_++);
    }
  }

 private:
  const StateOptions& options_;
  Identity identity_ = {};
  std::uint32_t sequence_ = 0;
};

Status run_shooting(State& state, Reporter& reporter, const StateOptions& options) {
  Keeper keeper(options, state);
  Status status = Status::ok;
  while (status == Status::ok && !keeper.is_enough(state) && reporter.go_on(state)) {
    status = shoot(state);
    if (status == Status::ok) {
      keeper.after_shot(state);
    }
  }
  keeper.save(state);
  return status;
}

Status run_gathering(State& state, Reporter& reporter) {
  const std::size_t n = state.scene.element_count;
  std::vector<std::uint16_t> share(n * n), back(n);
  std::vector<std::int32_t> exitent(n * state.scene.channels);
  FormFactorMatrix matrix = {share.data(), back.data(), exitent.data()};
  for (std::uint16_t e = 0; e < n; ++e) {
    const Status status = sample_matrix_row(state, matrix, e);
    if (status != Status::ok || !reporter.go_on(state)) {
      return status;
    }
  }
  for (int sweep = 0; sweep < kMostSweeps && !gather_sweep(state, matrix); ++sweep) {
    if (!reporter.go_on(state)) {
      break;
    }
  }
  book_gathering(state, matrix);
  return Status::converged;
}

glm::dvec3 three_channels(int channels, double unit, const std::function<Radiosity(int)>& radiosity) {
  glm::dvec3 b;
  for (int c = 0; c < 3; ++c) {
    b[c] = unit * radiosity(channels == 1 ? 0 : c).raw;
  }
  return b;
}

void read_out(const State& state, bool with_ambient, BakeResult& result) {
  const int channels = state.scene.channels;
  Radiosity ambient[kMaxChannels] = {};
  for (int c = 0; c < channels; ++c) {
    ambient[c] = with_ambient ? ambient_radiosity(state, c) : Radiosity::from_raw(0);
    result.ambient[static_cast<std::size_t>(c)] = ambient[c];
    result.ledger.push_back(ledger(state, c));
  }
  const double unit = result.device.unit_radiosity;
  for (std::uint16_t e = 0; e < state.scene.element_count; ++e) {
    result.element_radiosity.push_back(
        three_channels(channels, unit, [&](int c) { return element_radiosity(state, e, c, ambient[c]); }));
  }
  const VertexMap map = result.surface.map();
  for (std::uint32_t v = 0; v < map.vertex_count; ++v) {
    result.vertex_radiosity.push_back(three_channels(
        channels, unit, [&](int c) { return vertex_radiosity(state, map, v, c, ambient[c]); }));
  }
  const std::size_t received = std::size_t{state.scene.element_count} * state.scene.channels;
  result.received.assign(state.received, state.received + received);
  result.digest = result.display_digest = digest(state, map);
  result.shots = state.shots;
  result.eyes = state.eyes;
  result.withdrawn = state.withdrawn;
  result.gaps_closed = state.work.gaps_closed;
  result.spans_used = state.work.span_high_water;
  result.is_closed = state.is_closed;
  result.unshot_fraction = std::ldexp(static_cast<double>(unshot_fraction(state).raw), -32);
}

}  // namespace

BakeResult bake(const PreparedScene& scene, const BakeOptions& options, const Progress& progress,
                const std::function<Observer(const State&)>& observer) {
  BakeResult result;
  result.plan = make_plan(scene, options);
  result.device = make_device_scene(scene, result.plan.meshing);
  find_sights(result.device, result.plan.sizes);
  seal_bodies(result.device, result.plan.sizes);
  result.surface = make_surface_mesh(scene, result.device);
  SimulatedDevice device(result.plan.sizes);
  Settings settings = make_settings(options, result.plan);
  if (observer) {
    settings.observer = observer(device.state());
  }
  Status status = device.load(result.device.view(), settings);
  if (status != Status::ok) {
    throw InputError(scene.model->path + ": error: the core refuses the scene: " + describe(status));
  }
  Reporter reporter(progress);
  const Clock clock;
  status = options.solver == "gathering" ? run_gathering(device.state(), reporter)
                                         : run_shooting(device.state(), reporter, options.state);
  result.seconds = clock.seconds();
  if (status == Status::span_pool_full) {
    throw InputError(scene.model->path + ": error: " + describe(status) + " (" +
                     std::to_string(result.plan.sizes.spans) +
                     "); its faces pierce each other too often: let none cross another");
  }
  result.interrupted = reporter.is_stopped();
  read_out(device.state(), options.ambient, result);
  return result;
}

}  // namespace fixrad::host

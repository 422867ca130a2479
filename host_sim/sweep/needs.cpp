// SPDX-License-Identifier: MIT
#include "host_sim/sweep/needs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "host_sim/simulate/convexity.h"

namespace fixrad::host {
namespace {

void widen(Extent& extent, double value) {
  extent.least = extent.most == 0 ? value : std::min(extent.least, value);
  extent.most = std::max(extent.most, value);
}

double mean(const glm::dvec3& a) {
  return channel_sum(a) / 3;
}

void count_edges(const DeviceScene& device, SceneNeeds& needs) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, int> balance;
  for (const fixrad::Face& face : device.faces) {
    for (std::size_t k = 0; k < face.corner_count; ++k) {
      const std::uint16_t a = device.corners[face.first_corner + k];
      const std::uint16_t b = device.corners[face.first_corner + (k + 1) % face.corner_count];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  needs.edges = balance.size();
  needs.open_edges = static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

void measure_light(SceneNeeds& needs) {
  const BakeResult& result = needs.result;
  std::int32_t least = 0;
  for (std::size_t e = 0; e < result.device.mesh.elements.size(); ++e) {
    const MeshElement& element = result.device.mesh.elements[e];
    widen(needs.element_area, element.area);
    if (element.emission != glm::dvec3(0.0)) {
      ++needs.lamp_elements;
      widen(needs.lamp_watts, mean(element.emission) * element.area);
    }
    if (mean(result.element_radiosity[e]) > 0) {
      widen(needs.radiosity, mean(result.element_radiosity[e]));
    }
  }
  for (const std::int32_t received : result.received) {
    least = received > 0 && (least == 0 || received < least) ? received : least;
  }
  needs.darkest_units = least;
}

void measure_shape(SceneNeeds& needs) {
  const DeviceScene& device = needs.result.device;
  needs.is_grey = device.channels == 1;
  needs.is_convex = is_convex(device);
  needs.is_enclosed = is_enclosed(device.view());
  count_edges(device, needs);
  needs.sealed_faces = static_cast<std::size_t>(std::count_if(
      device.faces.begin(), device.faces.end(), [](const auto& face) { return face.is_sealed != 0; }));
  needs.buried_elements = static_cast<std::size_t>(
      std::count(device.sights.begin(), device.sights.end(), Sight::centroid_buried));
}

// Looks again from every eye point of the solution; returns the faces in views that have made no depth.
std::size_t count_depths(const std::vector<WorkRecorder::Eye>& eyes, const Settings& settings,
                         SceneNeeds& needs) {
  SimulatedDevice device(needs.result.plan.sizes);
  State& state = device.state();
  if (device.load(needs.result.device.view(), settings) != Status::ok) {
    return 0;
  }
  std::size_t faces = 0;
  for (const WorkRecorder::Eye& eye : eyes) {
    clear(state.row);
    const Status status = settings.engine(state.scene, eye.table, eye.sample, state.work, state.row);
    if (status != Status::ok || state.work.view_count == 0) {
      continue;
    }
    ++needs.views;
    if (state.work.views[0].depth_shift == 0) {
      ++needs.views_without_depth;
      faces += state.work.view_count;
    }
  }
  return faces;
}

// The work of the same solution in which every eye asks for every back.
std::optional<Work> work_with_backs(const BakeResult& result, const BakeOptions& options) {
  BakeResult general = result;
  for (fixrad::Face& face : general.device.faces) {
    face.is_sealed = 0;
  }
  SimulatedDevice device(general.plan.sizes);
  WorkRecorder recorder(device.state());
  Settings settings = make_settings(options, general.plan);
  settings.observer = recorder.observer();
  Status status = device.load(general.device.view(), settings);
  device.state().is_closed = false;
  while (status == Status::ok) {
    status = shoot(device.state());
  }
  return status == Status::converged ? count_work(general, options, recorder) : std::nullopt;
}

Omission two_channels(const BakeResult& result, const std::optional<Work>& work, const CostModel& model) {
  Sizes colour = result.plan.sizes;
  colour.channels = 3;
  Omission omission = {"channels", "two of three channels: everything is grey",
                       pool_bytes(colour) - pool_bytes(result.plan.sizes), std::nullopt};
  if (work) {
    Work twice = {};
    for (const WorkUnit unit : {kShare, kFaceShare, kUnshot}) {
      twice[unit] = 2 * (*work)[unit];
    }
    omission.cost = cost(model, twice);
  }
  return omission;
}

void find_omissions(const BakeOptions& options, const CostModel& model, const WorkRecorder& recorder,
                    SceneNeeds& needs) {
  const BakeResult& result = needs.result;
  const std::optional<Work> work =
      model.knows(options.engine) ? count_work(result, options, recorder) : std::nullopt;
  needs.cost = work ? std::optional(cost(model, *work)) : std::nullopt;
  if (needs.is_grey) {
    needs.omissions.push_back(two_channels(result, work, model));
  }
  if (!needs.is_convex && (result.is_closed || needs.sealed_faces > 0)) {
    const std::optional<Work> general = work ? work_with_backs(result, options) : std::nullopt;
    needs.omissions.push_back(
        {result.is_closed ? "backs" : "sealed_backs",
         result.is_closed ? "the backs of all faces: the scene is closed"
                          : "the backs of " + std::to_string(needs.sealed_faces) + " faces: no eye sees them",
         0, general ? std::optional(std::max(0.0, cost(model, *general) - *needs.cost)) : std::nullopt});
  }
  // A hemicube makes all depths before it turns them from side to side.
  const std::size_t depths = options.engine == "lunes"
                                 ? count_depths(recorder.eyes(), make_settings(options, result.plan), needs)
                                 : 0;
  if (needs.is_convex && depths > 0) {
    needs.omissions.push_back(
        {"depth", "depth of faces and tests of it: none hides another", 0,
         work ? std::optional(kDepthOfView * model.weights[kView] * static_cast<double>(depths))
              : std::nullopt});
  }
}

}  // namespace

SceneNeeds find_needs(const PreparedScene& scene, const BakeOptions& options, const CostModel& model,
                      const Progress& progress) {
  SceneNeeds needs;
  std::unique_ptr<WorkRecorder> recorder;
  needs.result = bake(scene, options, progress, [&](const State& state) {
    recorder = std::make_unique<WorkRecorder>(state);
    return recorder->observer();
  });
  if (!needs.result.interrupted) {
    measure_shape(needs);
    measure_light(needs);
    find_omissions(options, model, *recorder, needs);
  }
  return needs;
}

}  // namespace fixrad::host

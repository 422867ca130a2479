// SPDX-License-Identifier: MIT
#include <algorithm>

#include "host_sim/bake/closed_form_factors.h"
#include "host_sim/cli/session.h"
#include "host_sim/report/text.h"
#include "lib/transport/sampling.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kElements = 1500;
constexpr int kResolution = 64;
constexpr std::uint32_t kEyes = 4;  // an element
constexpr std::uint32_t kFinestRows = 0xffffffffu;

using Matrix = std::vector<std::vector<double>>;

// Mean over the elements of each input face of their rows, the receivers' shares divided among the faces that
// they lie on.
Matrix face_factors(const LoadedScene& scene, const BakeResult& solution_frame, State& state) {
  const std::size_t faces = scene.model.file_faces;
  const DeviceScene& device = solution_frame.device;
  std::vector<std::vector<std::pair<std::uint32_t, double>>> of_element(device.elements.size());
  std::vector<double> face_area(faces, 0.0), element_area(device.elements.size(), 0.0);
  for (const Overlap& o : device.overlaps) {
    const auto face = o.input_face % static_cast<std::uint32_t>(faces);
    of_element[o.element].push_back({face, o.area});
    element_area[o.element] += o.area;
    face_area[face] += o.area;
  }
  Matrix factors(faces, std::vector<double>(faces, 0.0));
  std::vector<double> row(faces);
  for (std::uint16_t e = 0; e < device.elements.size() && !is_interrupted(); ++e) {
    if (sample_element(state, e, kEyes, kFinestRows) != Status::ok) {
      throw InputError(scene.model.path +
                       ": error: a row shows more spans than the pool holds; let no faces pierce each other");
    }
    std::fill(row.begin(), row.end(), 0.0);
    for (std::size_t k = 0; k < device.elements.size(); ++k) {
      const double share = state.row.share[k] / static_cast<double>(kRowOne);
      for (const auto& [face, area] : of_element[k]) {
        row[face] += share * area / element_area[k];
      }
    }
    for (const auto& [face, area] : of_element[e]) {
      for (std::size_t j = 0; j < faces; ++j) {
        factors[face][j] += row[j] * area / face_area[face];
      }
    }
  }
  return factors;
}

// Rows of form factors from the core's solver, as the options choose it.
Matrix sampled_factors(const LoadedScene& scene, const BakeOptions& choice, const BakeResult& frame) {
  SimulatedDevice device(frame.plan.sizes);
  const Status status = device.load(frame.device.view(), make_settings(choice, frame.plan));
  if (status != Status::ok) {
    throw InputError(scene.model.path + ": error: the core refuses the scene: " + describe(status));
  }
  return face_factors(scene, frame, device.state());
}

// Closed forms wherever nothing can stand between two faces; rows are sampled only if some pair needs them.
Matrix best_factors(const LoadedScene& scene, const BakeOptions& choice, const BakeResult& frame) {
  const auto faces = static_cast<std::uint32_t>(scene.model.file_faces);
  ClosedFormFactors closed(scene.prepared, frame.device);
  Matrix factors(faces, std::vector<double>(faces, 0.0));
  std::vector<std::pair<std::uint32_t, std::uint32_t>> hidden;
  for (std::uint32_t i = 0; i < faces && !is_interrupted(); ++i) {
    for (std::uint32_t j = 0; j < faces; ++j) {
      const std::optional<double> factor = closed.factor(i, j);
      factors[i][j] = factor.value_or(0);
      if (!factor) {
        hidden.push_back({i, j});
      }
    }
  }
  if (!hidden.empty()) {
    const Matrix sampled = sampled_factors(scene, choice, frame);
    for (const auto& [i, j] : hidden) {
      factors[i][j] = sampled[i][j];
    }
  }
  return factors;
}

}  // namespace

int run_form_factors(const CommonOptions& options) {
  check_folder(options.csv);
  const auto scene = load_scene(options);
  BakeOptions choice = options.bake;
  choice.profile = "host";
  if (choice.engine != "rays") {
    choice.resolution = options.bake.resolution.value_or(kResolution);
  }
  choice.elements = options.bake.elements.value_or(
      std::max(kElements, 2 * static_cast<std::uint32_t>(scene->prepared.faces.size())));
  BakeResult frame;
  frame.plan = make_plan(scene->prepared, choice);
  frame.device = make_device_scene(scene->prepared, frame.plan.meshing);
  const Matrix factors =
      options.engine_chosen ? sampled_factors(*scene, choice, frame) : best_factors(*scene, choice, frame);
  if (is_interrupted()) {
    say(options, "interrupted: nothing written");
    return kInterrupted;
  }
  std::string text = "i,j,F\n";
  for (std::size_t i = 0; i < factors.size(); ++i) {
    for (std::size_t j = 0; j < factors[i].size(); ++j) {
      if (factors[i][j] > 0) {
        text += std::to_string(i) + "," + std::to_string(j) + ",";
        append_number(text, factors[i][j]);
        text += "\n";
      }
    }
  }
  write_text(options.csv, text);
  say(options, "wrote " + options.csv);
  return kDone;
}

}  // namespace fixrad::host

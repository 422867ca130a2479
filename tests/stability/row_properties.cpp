// SPDX-License-Identifier: MIT
// What the eyes of a scene see: rows of form factors, without a solution.
#include <array>
#include <cmath>
#include <map>

#include "tests/lib/solution.h"
#include "tests/stability/property_checks.h"

namespace fixrad::host {
namespace {

// Where faces run through each other or lie in one plane, their order decides ties of depth: parts of 2^20.
constexpr std::uint32_t kOrderOfFaces = 1u << 10;

// Of the sum of exchange areas.
constexpr double kReciprocity = 0.06;

// The row of form factors from the eye of element `e`, in share; by the finest table.
const std::uint32_t* look(Bench& bench, std::uint16_t e) {
  State& state = bench.state();
  clear(state.row);
  const EyeSample sample = {element_eye(state.scene, e), kRowOne, !state.is_closed, true};
  const DeltaTable& finest = state.settings.tables[state.settings.table_count - 1];
  return state.settings.engine(state.scene, finest, sample, state.work, state.row) == Status::ok
             ? state.row.share
             : nullptr;
}

bool is_clear(Bench& bench, std::uint16_t e) {
  State& state = bench.state();
  std::uint32_t share = 0;
  const Status status = hidden_share(state.scene, state.settings.probe[0], element_eye(state.scene, e),
                                     state.is_enclosed, state.work, share);
  return status == Status::ok && share <= kBuriedShare;
}

// Where each element of `a` is in `b`, by its eye and its face's normal; empty if some is not.
std::vector<std::uint16_t> places_in(const DeviceScene& a, const DeviceScene& b) {
  using Key = std::array<int, 6>;
  const auto key = [](const DeviceScene& device, const Element& e) {
    const auto& n = device.faces[e.face].normal;
    return Key{e.eye[0], e.eye[1], e.eye[2], n[0], n[1], n[2]};
  };
  std::map<Key, std::uint16_t> places;
  for (std::size_t e = 0; e < b.elements.size(); ++e) {
    places[key(b, b.elements[e])] = static_cast<std::uint16_t>(e);
  }
  std::vector<std::uint16_t> order;
  for (const Element& e : a.elements) {
    const auto found = places.find(key(a, e));
    if (found == places.end() || places.size() != a.elements.size()) {
      return {};
    }
    order.push_back(found->second);
  }
  return order;
}

// The plane of an element, and which side of it is lit.
std::array<std::int64_t, 4> plane_of(const DeviceScene& device, std::size_t e) {
  const fixrad::Face& face = device.faces[device.elements[e].face];
  const Vertex corner = device.vertices[device.corners[face.first_corner]];
  const std::int64_t height = face.normal[0] * std::int64_t{corner.x} +
                              face.normal[1] * std::int64_t{corner.y} +
                              face.normal[2] * std::int64_t{corner.z};
  return {face.normal[0], face.normal[1], face.normal[2], height / kUnit};
}

// The finest of lunes, on a mesh that is fine for so few faces.
constexpr std::uint32_t kFineElements = 300;
constexpr int kFineRows = 128;

// Exchange areas between faces, [face][face], from one row an element.
std::vector<double> exchange_areas(Bench& bench) {
  const DeviceScene& device = bench.device();
  const std::size_t faces = device.faces.size();
  std::vector<double> areas(faces * faces, 0.0);
  for (std::uint16_t e = 0; e < device.elements.size(); ++e) {
    const std::uint32_t* row = is_clear(bench, e) ? look(bench, e) : nullptr;
    for (std::size_t j = 0; row != nullptr && j < device.elements.size(); ++j) {
      areas[device.elements[e].face * faces + device.elements[j].face] +=
          static_cast<double>(device.elements[e].area) * row[j] / kRowOne;
    }
  }
  return areas;
}

}  // namespace

std::string shuffle_faces(const RandomScene& scene) {
  const Model model = model_of(scene);
  Model image = model;
  const std::vector<std::uint32_t> places = shuffled(model.faces.size(), scene.seed);
  for (std::size_t f = 0; f < places.size(); ++f) {
    image.faces[places[f]] = model.faces[f];
  }
  Bench a(model, scene, settings_of(scene)), b(image, scene, settings_of(scene));
  if (a.status() != Status::ok || b.status() != Status::ok) {
    return refusal(a.status() != Status::ok ? a : b);
  }
  const std::vector<std::uint16_t> order = places_in(a.device(), b.device());
  for (std::uint16_t e = 0; e < order.size(); ++e) {
    if (!is_clear(a, e)) {
      continue;  // inside a body, where a wall and what stands on it have one depth
    }
    const std::uint32_t *from = look(a, e), *to = look(b, order[e]);
    if (from == nullptr || to == nullptr) {
      return "a row is not sampled";
    }
    std::map<std::array<std::int64_t, 4>, std::int64_t> difference;  // by plane
    for (std::size_t j = 0; j < order.size(); ++j) {
      difference[plane_of(a.device(), j)] += static_cast<std::int64_t>(from[j]) - to[order[j]];
    }
    std::int64_t distance = 0;
    for (const auto& [plane, moved] : difference) {
      distance += std::abs(moved);
    }
    if (distance > kOrderOfFaces * (scene.bodies.empty() ? 0 : 1)) {
      return "element " + std::to_string(e) + " sees " + std::to_string(distance) +
             " of 2^20 elsewhere with the faces in another order";
    }
  }
  return {};
}

std::string reciprocate(const RandomScene& scene) {
  RandomScene fine = scene;
  fine.elements = kFineElements;
  fine.rows = kFineRows;
  fine.hemisphere = RandomScene::Hemisphere::lunes;
  Bench bench(model_of(fine), fine, settings_of(fine));
  if (bench.status() != Status::ok) {
    return refusal(bench);
  }
  const std::vector<double> areas = exchange_areas(bench);
  const std::size_t faces = bench.device().faces.size();
  double difference = 0, sum = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    for (std::size_t j = 0; j < faces; ++j) {
      difference += std::abs(areas[i * faces + j] - areas[j * faces + i]) / 2;
      sum += areas[i * faces + j];
    }
  }
  return difference <= kReciprocity * sum ? std::string()
                                          : "exchange areas of faces differ by " +
                                                std::to_string(difference / sum) + " from their transpose";
}

}  // namespace fixrad::host

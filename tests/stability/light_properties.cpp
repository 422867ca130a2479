// SPDX-License-Identifier: MIT
// How the solutions of related scenes are related: dimmed, shuffled, turned.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "host_sim/reference/counter_random.h"
#include "host_sim/simulate/convergence.h"
#include "tests/stability/property_checks.h"
#include "tests/stability/symmetries.h"

namespace fixrad::host {
namespace {

// An eye sees the same whenever it looks.
template <Engine Hemisphere>
Status look_without_a_turn(const Scene& scene, const DeltaTable& table, const EyeSample& sample,
                           Workspace& work, FormFactorRow& row) {
  EyeSample still = sample;
  still.eye.turn = 0;
  return Hemisphere(scene, table, still, work, row);
}

// One matrix of form factors, whatever the flux: elements shoot for themselves, with the finest table.
Settings one_matrix(const RandomScene& scene) {
  Settings settings = settings_of(scene);
  settings.engine = scene.hemisphere == RandomScene::Hemisphere::lunes ? look_without_a_turn<lune_rows>
                    : scene.hemisphere == RandomScene::Hemisphere::hemicube
                        ? look_without_a_turn<hemicube_rows>
                        : look_without_a_turn<hemicube_pixels>;
  settings.tables += settings.table_count - 1;
  settings.table_count = 1;
  settings.flux_per_row = Fraction::from_raw(0);
  settings.flux_per_eye = Fraction::from_raw(0xffffffffu);
  settings.overshoot = false;
  return settings;
}

// How far rounding may take all that is received: what is unshot, and a unit an element and shot, each
// multiplied by 1 / (1 - reflectance) as it bounces on.
double rounding(const State& state, std::size_t c) {
  const ErrorBound bound = error_bounds(state)[c];
  return (bound.unshot + static_cast<double>(state.scene.element_count) * (state.shots + 1.0)) /
         (1 - bound.largest_reflectance);
}

std::string same_flux(const RandomScene& scene, Model image, const char* what) {
  Bench a(model_of(scene), scene, settings_of(scene)), b(std::move(image), scene, settings_of(scene));
  if (a.status() != Status::ok) {
    return refusal(a);
  }
  if (!a.run() || !b.run()) {
    return unsolved(a);
  }
  return a.received() == b.received() ? std::string() : std::string("another flux with ") + what;
}

// A scene's tables as a rotation of the grid makes them.
DeviceScene rotated(DeviceScene device, std::size_t rotation) {
  const auto turn = [&](auto& v, int extent) {
    const glm::ivec3 image = image_of(glm::ivec3(v[0], v[1], v[2]), rotation, extent);
    for (int k = 0; k < 3; ++k) {
      v[k] = static_cast<std::remove_reference_t<decltype(v[0])>>(image[k]);
    }
  };
  for (Vertex& vertex : device.vertices) {
    std::int16_t v[3] = {vertex.x, vertex.y, vertex.z};
    turn(v, kGridMax);
    vertex = {v[0], v[1], v[2]};
  }
  for (fixrad::Face& face : device.faces) {
    turn(face.normal, 0);
    turn(face.tangent, 0);
    turn(face.axis_u, 0);
    turn(face.axis_v, 0);
    turn(face.origin, kGridMax);
  }
  for (Element& element : device.elements) {
    turn(element.eye, kEyeScale * kGridMax);
  }
  return device;
}

// x, y, z to y, z, x and back, no sign changed.
constexpr std::size_t kCyclic[] = {8, 16};

}  // namespace

std::string scale_light(const RandomScene& scene) {
  const Settings settings = one_matrix(scene);
  Bench whole(model_of(scene), scene, settings), part(model_of(scene), scene, settings);
  if (whole.status() != Status::ok) {
    return refusal(whole);
  }
  constexpr std::uint32_t kDivisor = 3;
  DeviceScene dim = part.device();
  for (fixrad::Material& material : dim.materials) {
    for (std::uint32_t& emission : material.emission) {
      emission /= kDivisor;
    }
  }
  if (part.load(dim, settings) != Status::ok || !whole.run() || !part.run()) {
    return unsolved(part.status() == Status::converged ? whole : part);
  }
  if (whole.state().sweep.kind != SourceKind::element || part.state().sweep.kind != SourceKind::element) {
    return {};  // groups shot: another matrix
  }
  const std::vector<std::int32_t> all = whole.received(), third = part.received();
  const auto channels = static_cast<std::size_t>(whole.device().channels);
  for (std::size_t c = 0; c < channels; ++c) {
    double distance = 0;
    for (std::size_t i = c; i < all.size(); i += channels) {
      distance += std::abs(static_cast<double>(all[i]) - kDivisor * static_cast<double>(third[i]));
    }
    const double bound = rounding(whole.state(), c) + kDivisor * rounding(part.state(), c);
    if (distance > bound) {
      return "channel " + std::to_string(c) + ": a third of the emission gives " + std::to_string(distance) +
             " units else, more than " + std::to_string(bound);
    }
  }
  return {};
}

std::vector<std::uint32_t> shuffled(std::size_t n, std::uint64_t seed) {
  std::vector<std::uint32_t> order(n);
  CounterRandom random(seed, 1, n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto j = static_cast<std::size_t>(random.next() * static_cast<double>(i + 1));
    order[i] = order[j];
    order[j] = static_cast<std::uint32_t>(i);
  }
  return order;
}

std::string shuffle_vertices(const RandomScene& scene) {
  const Model model = model_of(scene);
  Model image = model;
  const std::vector<std::uint32_t> places = shuffled(model.positions.size(), scene.seed);
  const std::vector<std::uint32_t> paints = shuffled(model.materials.size(), scene.seed);
  for (std::size_t v = 0; v < places.size(); ++v) {
    image.positions[places[v]] = model.positions[v];
  }
  for (std::size_t m = 0; m < paints.size(); ++m) {
    image.materials[paints[m]] = model.materials[m];
  }
  for (Face& face : image.faces) {
    face.material = paints[face.material];
    for (std::uint32_t& v : face.corners) {
      v = places[v];
    }
  }
  return same_flux(scene, std::move(image), "vertices and materials in another order");
}

std::string turn_axes(const RandomScene& scene) {
  Bench a(model_of(scene), scene, settings_of(scene)), b(model_of(scene), scene, settings_of(scene));
  if (a.status() != Status::ok) {
    return refusal(a);
  }
  const std::size_t rotation = kCyclic[scene.seed % 2];
  const DeviceScene image = rotated(b.device(), rotation);
  if (b.load(image, settings_of(scene)) != Status::ok) {
    return refusal(b);
  }
  if (!a.run() || !b.run()) {
    return unsolved(a);
  }
  return a.received() == b.received() ? std::string()
                                      : "another flux after rotation " + std::to_string(rotation);
}

}  // namespace fixrad::host

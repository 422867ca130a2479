// SPDX-License-Identifier: MIT
#include "tests/lib/solution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/simulate/eye_sights.h"

namespace fixrad::host {

Settings settings_with(int resolution, Fraction stop) {
  Settings settings;
  settings.engine = hemicube_rows;
  settings.tables = delta_table(resolution);
  settings.table_count = 1;
  settings.probe = &kDelta8;
  settings.stop = stop;
  return settings;
}

Settings lune_settings(int resolution, Fraction stop) {
  Settings settings;
  settings.engine = lune_rows;
  settings.tables = kLunes;
  settings.table_count = static_cast<std::uint8_t>(lune_table(resolution) - kLunes + 1);
  settings.probe = kLunes;
  settings.stop = stop;
  return settings;
}

Sizes sizes_for(const DeviceScene& device, std::uint32_t spans, const Settings& settings) {
  const auto faces = static_cast<std::uint32_t>(device.faces.size());
  return {static_cast<std::uint32_t>(device.vertices.size()),
          faces,
          static_cast<std::uint32_t>(device.elements.size()),
          spans != 0 ? spans : 2 * faces + 1,
          static_cast<std::uint32_t>(device.channels),
          settings.engine == hemicube_pixels ? 1u << settings.tables[0].resolution_log2 : 0u};
}

Solution::Solution(Model model, const SolveOptions& options, bool has_sights) : model_(std::move(model)) {
  prepared_ = prepare(model_);
  const std::uint32_t patches = options.patches != 0 ? options.patches : options.elements / 4;
  device_ = make_device_scene(prepared_, make_uniform(prepared_, options.elements, patches));
  const Sizes sizes = sizes_for(device_, options.spans, options.settings);
  if (has_sights) {
    find_sights(device_, sizes);
  }
  solver_ = std::make_unique<SimulatedDevice>(sizes);
  const Status status = solver_->load(device_.view(), options.settings);
  EXPECT_EQ(status, Status::ok) << describe(status);
}

Status Solution::run() {
  Status status = Status::ok;
  while (status == Status::ok) {
    status = shoot(state());
  }
  return status;
}

Status Solution::run(int shots) {
  Status status = Status::ok;
  for (int i = 0; i < shots && status == Status::ok; ++i) {
    status = shoot(state());
  }
  return status;
}

double Solution::radiosity(std::uint32_t element, int channel, bool with_ambient) const {
  const Radiosity ambient = with_ambient ? ambient_radiosity(state(), channel) : Radiosity::from_raw(0);
  return element_radiosity(state(), static_cast<std::uint16_t>(element), channel, ambient).raw *
         device_.unit_radiosity;
}

std::vector<double> Solution::radiosities(int channel, bool with_ambient) const {
  std::vector<double> all;
  for (std::uint32_t e = 0; e < device_.elements.size(); ++e) {
    all.push_back(radiosity(e, channel, with_ambient));
  }
  return all;
}

std::vector<double> Solution::face_means(int channel) const {
  std::vector<glm::dvec3> elements;
  for (const double b : radiosities(channel)) {
    elements.emplace_back(b);
  }
  std::vector<double> means;
  for (const glm::dvec3& mean : host::face_means(model_, device_.overlaps, elements)) {
    means.push_back(mean.x);
  }
  return means;
}

std::int64_t Solution::imbalance() const {
  std::int64_t worst = 0;
  for (int c = 0; c < device_.channels; ++c) {
    worst = std::max(worst, std::abs(ledger(state(), c).imbalance()));
  }
  return worst;
}

std::uint64_t Solution::digest() const {
  const SurfaceMesh mesh = make_surface_mesh(prepared_, device_);
  return fixrad::digest(state(), mesh.map());
}

EyePoint element_eye(const Scene& scene, std::uint32_t element, std::uint8_t turn) {
  const Element record = flash_read(scene.elements, element);
  return {vec(record.eye), record.face, turn};
}

Difference relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, sum = 0, mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
    sum += std::abs(a[i] - b[i]);
    mean += b[i];
  }
  return {largest / mean * static_cast<double>(a.size()), sum / mean};
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/bake/point_gatherer.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <stdexcept>

namespace fixrad::host {
namespace {

// 64 lunes: 128 change the error of irradiance at points by less than a tenth of it, 32 add a third.
constexpr int kLunesOfGather = 64;
constexpr std::uint32_t kMostSpans = 65535;

Sizes sizes_for(const BakeResult& result) {
  Sizes sizes = result.plan.sizes;
  sizes.pixel_resolution = 0;
  sizes.spans = kMostSpans;  // eyes may stand where no element's eye stood, and see more
  return sizes;
}

}  // namespace

// A device a thread with the same solution: a gather uses the row and the views as scratch memory.
struct PointGatherer::Impl {
  explicit Impl(const BakeResult& result)
      : scene(result.device.view()),
        unit_radiosity(result.device.unit_radiosity),
        sizes(sizes_for(result)),
        received(result.received) {
    std::copy(result.ambient.begin(), result.ambient.end(), ambient);
  }

  State& state() {
    std::unique_ptr<SimulatedDevice>& device = devices.local();
    if (!device) {
      device = std::make_unique<SimulatedDevice>(sizes);
      const Status status = device->load(scene, Settings{});
      if (status != Status::ok) {
        throw InputError(std::string("error: the core refuses the scene: ") + describe(status));
      }
      std::copy(received.begin(), received.end(), device->state().received);
    }
    return device->state();
  }

  Scene scene;
  double unit_radiosity;
  Sizes sizes;
  std::vector<std::int32_t> received;
  Radiosity ambient[kMaxChannels] = {};
  tbb::enumerable_thread_specific<std::unique_ptr<SimulatedDevice>> devices;
};

PointGatherer::PointGatherer(const BakeResult& result) : impl_(std::make_unique<Impl>(result)) {
  impl_->state();
}

PointGatherer::~PointGatherer() = default;

VertexLight PointGatherer::gather(const VertexGather& vertex) const {
  VertexLight light = {};
  const Status status =
      gather_vertex(impl_->state(), *lune_table(kLunesOfGather), correct_direct_light, vertex.points.data(),
                    static_cast<std::uint8_t>(vertex.points.size()), vertex.enough, impl_->ambient, light);
  if (status != Status::ok) {
    throw std::runtime_error(std::string("a gather at a vertex failed: ") + describe(status));
  }
  return light;
}

glm::dvec3 PointGatherer::physical(const Radiosity (&of)[kMaxChannels]) const {
  glm::dvec3 b;
  for (int c = 0; c < 3; ++c) {
    b[c] = impl_->unit_radiosity * of[impl_->scene.channels == 1 ? 0 : c].raw;
  }
  return b;
}

std::uint64_t PointGatherer::digest_with(const std::vector<Radiosity>& displayed) const {
  return digest(impl_->state(), displayed.data(), static_cast<std::uint32_t>(displayed.size()));
}

}  // namespace fixrad::host

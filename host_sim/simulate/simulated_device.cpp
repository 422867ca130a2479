// SPDX-License-Identifier: MIT
#include "host_sim/simulate/simulated_device.h"

#include <cstdint>
#include <vector>

namespace fixrad::host {

struct SimulatedDevice::Arrays {
  explicit Arrays(const Sizes& s)
      : received(s.elements * s.channels),
        accounts(s.channels * account_words(s.elements, s.faces)),
        views(s.faces),
        directions(s.vertices),
        spans(s.spans),
        items(s.pixel_resolution * s.pixel_resolution),
        share(s.elements) {}

  std::vector<std::int32_t> received, accounts;
  std::vector<FaceView> views;
  std::vector<Direction> directions;
  std::vector<Span> spans;
  std::vector<Item> items;
  std::vector<std::uint32_t> share;
};

SimulatedDevice::SimulatedDevice(const Sizes& sizes)
    : sizes_(sizes), arrays_(std::make_unique<Arrays>(sizes)) {}

SimulatedDevice::~SimulatedDevice() = default;

Status SimulatedDevice::load(const Scene& scene, const Settings& settings) {
  const Capacity capacity = {
      static_cast<std::uint16_t>(sizes_.vertices), static_cast<std::uint16_t>(sizes_.faces),
      static_cast<std::uint16_t>(sizes_.elements), static_cast<std::uint8_t>(sizes_.channels)};
  const Status status = check_scene(scene, capacity);
  if (status == Status::ok) {
    Arrays& a = *arrays_;
    state_.work = {a.directions.data(),
                   a.views.data(),
                   a.spans.data(),
                   a.items.data(),
                   static_cast<std::uint32_t>(a.items.size()),
                   static_cast<std::uint16_t>(sizes_.spans),
                   0,
                   0,
                   0,
                   {},
                   0};
    state_.row = {a.share.data(), scene.element_count, 0, 0};
    state_.received = a.received.data();
    state_.accounts = a.accounts.data();
    reset(state_, scene, settings);
  }
  return status;
}

const char* describe(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::converged:
      return "converged";
    case Status::too_many_vertices:
      return "too many vertices for the profile";
    case Status::too_many_faces:
      return "too many faces for the profile";
    case Status::too_many_elements:
      return "too many elements for the profile; ask for fewer with --elements";
    case Status::bad_channel_count:
      return "the number of colour channels is neither 1 nor 3";
    case Status::bad_index:
      return "a record points outside its table";
    case Status::bad_grid:
      return "an element grid does not fit its face";
    case Status::vertex_off_grid:
      return "a vertex lies outside the device's grid";
    case Status::repeated_corner:
      return "a face uses a vertex twice";
    case Status::zero_area:
      return "a face or an element has no area";
    case Status::not_planar:
      return "a face is not planar within the device's grid";
    case Status::not_convex:
      return "a face is not convex";
    case Status::reflectance_not_below_one:
      return "a reflectance rounds to 1; lower it or use --max-reflectance 0.95";
    case Status::no_emitter:
      return "nothing emits light; give a material a Ke";
    case Status::flux_overflow:
      return "the emitted flux leaves no headroom for its reflections";
    case Status::span_pool_full:
      return "a row shows more spans than the pool holds";
    case Status::item_buffer_too_small:
      return "the item buffer is smaller than the hemicube's resolution";
    case Status::bad_frame:
      return "a face's tangent is not perpendicular to its normal, or its axes leave the grid";
    case Status::bad_unit:
      return "a shift of the flux or radiosity unit is out of range";
    case Status::in_progress:
      return "a shot is under way: step again";
    case Status::bad_eye:
      return "an eye point does not lie on the lit side of its face";
  }
  return "unknown status";
}

}  // namespace fixrad::host

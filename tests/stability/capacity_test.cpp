// SPDX-License-Identifier: MIT
// A solver with room for just what a scene needs solves it; with one slot less it says which, and loses
// nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/simulate/simulated_device.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

struct Filled {
  Filled() : prepared(prepare(model)), device(make_device_scene(prepared, make_uniform(prepared, 80, 20))) {
    settings = lune_settings(16, fraction(1, 100));
    sizes = sizes_for(device, 0, settings);
    SimulatedDevice solver(sizes);
    status = solver.load(device.view(), settings);
    while (status == Status::ok) {
      status = shoot(solver.state());
    }
    received.assign(solver.state().received, solver.state().received + device.elements.size());
    sizes.spans = solver.state().work.span_high_water;
  }

  Model model = room_with_box(Stand::closed_on_floor, 0.3);
  PreparedScene prepared;
  DeviceScene device;
  Settings settings;
  Sizes sizes = {};
  Status status = Status::ok;
  std::vector<std::int32_t> received;
};

TEST(Capacity, TheLastSlotOfEverythingGivesTheSameBits) {
  const Filled filled;
  ASSERT_EQ(filled.status, Status::converged);
  SimulatedDevice solver(filled.sizes);
  Status status = solver.load(filled.device.view(), filled.settings);
  while (status == Status::ok) {
    status = shoot(solver.state());
  }
  EXPECT_EQ(status, Status::converged);
  EXPECT_TRUE(std::equal(filled.received.begin(), filled.received.end(), solver.state().received));
  EXPECT_EQ(solver.state().work.span_high_water, filled.sizes.spans);
}

TEST(Capacity, OneSlotLessIsRefusedByName) {
  const Filled filled;
  const auto load_with = [&](Sizes sizes) {
    SimulatedDevice solver(sizes);
    return solver.load(filled.device.view(), filled.settings);
  };
  Sizes vertices = filled.sizes, faces = filled.sizes, elements = filled.sizes;
  --vertices.vertices;
  --faces.faces;
  --elements.elements;
  EXPECT_EQ(load_with(vertices), Status::too_many_vertices);
  EXPECT_EQ(load_with(faces), Status::too_many_faces);
  EXPECT_EQ(load_with(elements), Status::too_many_elements);
}

TEST(Capacity, OneSpanLessStopsWithABalancedLedgerAndAnUnchangedState) {
  const Filled filled;
  Sizes sizes = filled.sizes;
  --sizes.spans;
  SimulatedDevice solver(sizes);
  Status status = solver.load(filled.device.view(), filled.settings);
  std::vector<std::int32_t> before(filled.received.size(), 0);
  while (status == Status::ok) {
    before.assign(solver.state().received, solver.state().received + before.size());
    status = shoot(solver.state());
  }
  EXPECT_EQ(status, Status::span_pool_full);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), solver.state().received));
  EXPECT_EQ(ledger(solver.state(), 0).imbalance(), 0);
  EXPECT_EQ(shoot(solver.state()), Status::span_pool_full) << "it stays so";
}

}  // namespace
}  // namespace fixrad::host

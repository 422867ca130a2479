// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>

#include "host_sim/reference/twin.h"
#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

// The arithmetic line of `fixrad compare`: the integer core against the same shots in double.
ArithmeticError arithmetic_error(const PreparedScene& scene, const BakeOptions& options) {
  std::unique_ptr<Recorder> recorder;
  const BakeResult result = bake(scene, options, {}, [&](const State& state) {
    recorder = std::make_unique<Recorder>(state);
    return recorder->observer();
  });
  const DeviceScene& device = result.device;
  Twin twin(device.view(), make_settings(options, result.plan));
  twin.replay(*recorder);
  std::vector<double> areas;
  for (const MeshElement& e : device.mesh.elements) {
    areas.push_back(e.area);
  }
  const double area_unit = 1 / (8 * device.grid.scale * device.grid.scale);
  return compare_arithmetic(result.element_radiosity, twin.element_radiosity(device.unit_watts, area_unit),
                            areas);
}

// Small elements and many rows: a grid line that misses its place by a unit of the row moves much of an
// element's light. Rounding alone stays below these figures; a crossing taken at the wrong end of a row, or a
// grid line cut to too few bits, costs single elements 10 % and more.
TEST(Arithmetic, KeepsToItsBoundOnALargeMeshWithANarrowGap) {
  const auto scene = sample("gap");
  BakeOptions options = on_profile("large");
  options.engine = "lunes";
  options.resolution = 64;
  const ArithmeticError error = arithmetic_error(scene->prepared, options);
  EXPECT_LE(error.mean, 0.0015);
  EXPECT_LE(error.max, 0.015);
}

}  // namespace
}  // namespace fixrad::host::testing

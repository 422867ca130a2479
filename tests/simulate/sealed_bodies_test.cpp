// SPDX-License-Identifier: MIT
#include "host_sim/simulate/sealed_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "host_sim/simulate/eye_sights.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

struct Sealed {
  Model model;
  PreparedScene prepared;
  DeviceScene device;
  Sizes sizes;

  explicit Sealed(const Model& scene, const Settings& settings = {})
      : model(scene), prepared(prepare(model)) {
    device = make_device_scene(prepared, make_uniform(prepared, 200, 50));
    sizes = sizes_for(device, 0, settings);
    find_sights(device, sizes);
    seal_bodies(device, sizes);
  }

  /// Sealed faces among `count` faces from `first` on.
  std::ptrdiff_t count(std::size_t first, std::size_t count) const {
    const auto begin = device.faces.begin() + static_cast<std::ptrdiff_t>(first);
    return std::count_if(begin, begin + static_cast<std::ptrdiff_t>(count),
                         [](const fixrad::Face& face) { return face.is_sealed != 0; });
  }
};

// A lit room of 4 m, without its ceiling on request, with a box that has no bottom `lift` above its floor.
Model box_without_bottom(double lift, bool has_ceiling = true) {
  ModelBuilder builder;
  const std::uint32_t grey = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.room(glm::dvec3(0.0), glm::dvec3(4.0), {grey, grey, grey, grey, lamp, grey});
  builder.box({1.5, lift, 1.5}, {2.5, 1.0 + lift, 2.5}, 0.3, grey, false);
  Model model = builder.model();
  if (!has_ceiling) {
    model.faces.erase(model.faces.begin() + 3);
    model.file_faces = model.faces.size();
  }
  return model;
}

TEST(SealedBodies, ABoxWithoutBottomIsSealedByTheFloorItStandsOn) {
  const Sealed scene(box_without_bottom(0.0));
  ASSERT_EQ(scene.device.faces.size(), 11u);
  EXPECT_EQ(scene.count(6, 5), 5);
}

TEST(SealedBodies, ABoxWithoutBottomAboveTheFloorIsOpen) {
  const Sealed scene(box_without_bottom(0.25));
  EXPECT_EQ(scene.count(6, 5), 0);
}

TEST(SealedBodies, AClosedBoxIsSealedWhereverItIs) {
  for (const Stand stand : {Stand::closed_on_floor, Stand::floating}) {
    const Sealed scene(room_with_box(stand, 0.3));
    ASSERT_EQ(scene.device.faces.size(), 12u);
    EXPECT_EQ(scene.count(6, 6), 6);
  }
}

TEST(SealedBodies, ARoomWithoutCeilingIsOpen) {
  const Sealed scene(box_without_bottom(0.0, false));
  ASSERT_EQ(scene.device.faces.size(), 10u);
  EXPECT_EQ(scene.count(0, 5), 0);
  EXPECT_EQ(scene.count(5, 5), 5) << "the box in it is not";
}

TEST(SealedBodies, NothingIsSealedWithoutSights) {
  const Model model = cornell();
  const PreparedScene prepared = prepare(model);
  DeviceScene device = make_device_scene(prepared, make_uniform(prepared, 150, 30));
  seal_bodies(device, sizes_for(device, 0, Settings{}));
  EXPECT_TRUE(std::none_of(device.faces.begin(), device.faces.end(),
                           [](const fixrad::Face& face) { return face.is_sealed != 0; }));
}

std::vector<double> radiosities(const DeviceScene& device, const Sizes& sizes, const Settings& settings) {
  SimulatedDevice solver(sizes);
  EXPECT_EQ(solver.load(device.view(), settings), Status::ok);
  Status status = Status::ok;
  while (status == Status::ok) {
    status = shoot(solver.state());
  }
  EXPECT_EQ(status, Status::converged);
  std::vector<double> all;
  for (std::uint16_t e = 0; e < device.elements.size(); ++e) {
    all.push_back(element_radiosity(solver.state(), e, 0, Radiosity::from_raw(0)).raw);
  }
  return all;
}

// No eye sees a sealed back but for rounding at outlines.
TEST(SealedBodies, ChangeTheLightByNoMoreThanRounding) {
  const Settings settings = lune_settings(32, Fraction::from_raw(4294967));
  Sealed scene(cornell(), settings);
  ASSERT_GT(scene.count(0, scene.device.faces.size()), 5);
  DeviceScene open = scene.device;
  for (fixrad::Face& face : open.faces) {
    face.is_sealed = 0;
  }
  const Difference difference = relative_difference(radiosities(scene.device, scene.sizes, settings),
                                                    radiosities(open, scene.sizes, settings));
  EXPECT_LT(difference.mean, 0.002);
  EXPECT_LT(difference.largest, 0.01);
}

}  // namespace
}  // namespace fixrad::host

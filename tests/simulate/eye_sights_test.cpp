// SPDX-License-Identifier: MIT
#include "host_sim/simulate/eye_sights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr double kHalfBox = 0.5, kMiddle = 2.0;

DeviceScene with_sights(const Model& model, std::uint32_t elements) {
  const PreparedScene prepared = prepare(model);
  DeviceScene device = make_device_scene(prepared, make_uniform(prepared, elements, elements / 4));
  find_sights(device, sizes_for(device, 0, Settings{}));
  return device;
}

// From the box's outline on the floor to the nearest and to the farthest point of an element, in the larger
// of the two axes; below 0 inside. The box is not turned.
struct Reach {
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest, centroid = 0;
};

double outside_box(glm::dvec3 p) {
  return std::max(std::abs(p.x - kMiddle), std::abs(p.z - kMiddle)) - kHalfBox;
}

Reach reach_of(const MeshElement& element) {
  Reach reach;
  glm::dvec3 low = element.polygon[0], high = low;
  for (const glm::dvec3& p : element.polygon) {
    low = glm::min(low, p);
    high = glm::max(high, p);
    reach.farthest = std::max(reach.farthest, outside_box(p));
  }
  reach.nearest = outside_box(glm::clamp(glm::dvec3(kMiddle), low, high));
  reach.centroid = outside_box(element.centroid);
  return reach;
}

TEST(EyeSights, TellWhatLiesUnderABoxFromWhatItsOutlineCutsAndWhatIsClear) {
  const DeviceScene device = with_sights(room_with_box(Stand::without_bottom, 0.0), 640);
  ASSERT_EQ(device.sights.size(), device.elements.size());
  int buried = 0, cut = 0, away = 0, clear = 0;
  for (std::size_t e = 0; e < device.elements.size(); ++e) {
    if (device.mesh.elements[e].centroid.y > 1e-3) {
      continue;  // not of the floor
    }
    const Reach reach = reach_of(device.mesh.elements[e]);
    if (reach.centroid < -0.02) {
      EXPECT_EQ(device.sights[e], Sight::centroid_buried) << "element " << e;
      ++buried;
    } else if (reach.centroid > 0.02 && reach.nearest < -0.02) {
      EXPECT_EQ(device.sights[e], Sight::centroid_clear) << "element " << e;
      ++cut;
    } else if (reach.nearest > 0.3) {
      EXPECT_NE(device.sights[e], Sight::centroid_buried) << "element " << e;
      EXPECT_NE(device.sights[e], Sight::unknown) << "element " << e;
      clear += device.sights[e] == Sight::all_clear ? 1 : 0;
      ++away;
    }
  }
  EXPECT_GT(buried, 2);
  EXPECT_GT(cut, 2);
  EXPECT_GT(away, 50);
  EXPECT_GT(clear, away * 4 / 5) << "rounding at outlines may cost a few eyes their certainty";
}

TEST(EyeSights, AreAllClearInAnEmptyRoom) {
  const DeviceScene device = with_sights(cube(0.5, {0, 0, 0, 1, 0, 0}), 150);
  for (std::size_t e = 0; e < device.elements.size(); ++e) {
    EXPECT_EQ(device.sights[e], Sight::all_clear) << "element " << e << ", face " << device.elements[e].face;
  }
}

TEST(EyeSights, AreLeftOutWhereTheSceneDoesNotFitThePools) {
  const Model model = cornell();
  const PreparedScene prepared = prepare(model);
  DeviceScene device = make_device_scene(prepared, make_uniform(prepared, 150, 30));
  Sizes sizes = sizes_for(device, 0, Settings{});
  sizes.faces -= 1;
  find_sights(device, sizes);
  EXPECT_TRUE(device.sights.empty());
}

}  // namespace
}  // namespace fixrad::host

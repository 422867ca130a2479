// SPDX-License-Identifier: MIT
// A grey scene carries one channel: each of three equal ones would have got the same flux, to the bit.
#include <gtest/gtest.h>

#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

// The materials of a model in grey: the mean of their channels.
Model in_grey(Model model) {
  for (Material& material : model.materials) {
    const auto mean = [](glm::dvec3 a) { return glm::dvec3((a.x + a.y + a.z) / 3); };
    material.reflectance = mean(material.reflectance);
    material.emission = mean(material.emission);
  }
  return model;
}

// Three channels, each like the first.
DeviceScene in_three_channels(DeviceScene device) {
  device.channels = 3;
  for (fixrad::Material& material : device.materials) {
    for (int c = 1; c < 3; ++c) {
      material.reflectance[c] = material.reflectance[0];
      material.emission[c] = material.emission[0];
    }
  }
  return device;
}

DeviceScene grey_device(const Model& model, std::uint32_t elements) {
  return make_device_scene(prepare(model), make_uniform(prepare(model), elements, elements / 4));
}

// One scene twice in step, in grey and in three equal channels.
class GreyAndColour {
 public:
  GreyAndColour(const DeviceScene& grey, const Settings& settings)
      : grey_(grey), colour_(in_three_channels(grey)), one_(sizes_of(grey_)), three_(sizes_of(colour_)) {
    EXPECT_EQ(one_.load(grey_.view(), settings), Status::ok);
    EXPECT_EQ(three_.load(colour_.view(), settings), Status::ok);
  }

  // Shoots once in both; false at the end. Both must decide alike.
  bool shoot_both() {
    const Status status = shoot(one_.state());
    EXPECT_EQ(shoot(three_.state()), status);
    return status == Status::ok;
  }

  void expect_equal_channels() const {
    const State& one = one_.state();
    const State& three = three_.state();
    ASSERT_EQ(one.shots, three.shots);
    ASSERT_EQ(one.eyes, three.eyes);
    for (unsigned c = 0; c < 3; ++c) {
      ASSERT_EQ(one.escaped[0], three.escaped[c]) << "shot " << one.shots << " channel " << c;
      ASSERT_EQ(one.back[0], three.back[c]) << "shot " << one.shots << " channel " << c;
      for (unsigned e = 0; e < one.scene.element_count; ++e) {
        ASSERT_EQ(one.received[e], three.received[3 * e + c])
            << "shot " << one.shots << " element " << e << " channel " << c;
      }
    }
  }

  const State& grey() const { return one_.state(); }
  std::uint32_t flux_bytes(int channels) const {
    const Sizes one = sizes_of(grey_), three = sizes_of(colour_);
    const Sizes none = {one.vertices, one.faces, one.elements, one.spans, 0, 0};
    return pool_bytes(channels == 1 ? one : three) - pool_bytes(none);
  }

 private:
  static Sizes sizes_of(const DeviceScene& device) {
    return sizes_for(device, 2 * static_cast<std::uint32_t>(device.faces.size()) + 40, Settings{});
  }

  DeviceScene grey_, colour_;
  SimulatedDevice one_, three_;
};

void expect_alike(const Model& model, bool overshoot) {
  Settings settings = lune_settings(16, fraction(1, 1000));
  settings.overshoot = overshoot;
  GreyAndColour both(grey_device(in_grey(model), 150), settings);
  while (both.shoot_both()) {
    ASSERT_NO_FATAL_FAILURE(both.expect_equal_channels());
  }
  EXPECT_GT(both.grey().shots, 20u);
  EXPECT_EQ(ledger(both.grey(), 0).imbalance(), 0);
}

TEST(Grey, EveryShotGivesEveryElementWhatEachOfThreeEqualChannelsGives) {
  ASSERT_NO_FATAL_FAILURE(expect_alike(cornell(), true));
  ASSERT_NO_FATAL_FAILURE(expect_alike(cornell(), false));
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(expect_alike(random_closed_room(seed), seed % 2 == 0));
    ASSERT_NO_FATAL_FAILURE(expect_alike(random_open_room(seed), seed % 2 == 1));
  }
}

TEST(Grey, TakesAtMostHalfTheMemoryOfThreeChannelsForFlux) {
  const GreyAndColour both(grey_device(in_grey(cornell()), 250), lune_settings(16, fraction(1, 100)));
  EXPECT_EQ(3 * both.flux_bytes(1), both.flux_bytes(3));
}

}  // namespace
}  // namespace fixrad::host

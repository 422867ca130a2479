// SPDX-License-Identifier: MIT
// Closed rooms in which everything emits: hundreds of thousands of bounces, and channels that differ.
#include "tests/stability/hard_scenes.h"
#include "tests/stability/laws.h"

namespace fixrad::host {
namespace {

constexpr std::array<double, 6> kAllEmit = {1, 1, 1, 1, 1, 1};
constexpr double kPermille = 0.001;

template <int Numerator, int Denominator>
std::vector<Model> furnace() {
  return {cube(static_cast<double>(Numerator) / Denominator, kAllEmit)};
}

template <int Numerator, int Denominator>
std::vector<Finding> furnace_law(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  const double expected = static_cast<double>(Denominator) / (Denominator - Numerator);
  expect_radiosity(lights[0], 0, 5, expected, kPermille, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

std::vector<Model> furnace_with_a_dark_channel() {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material({0.5, 0.9, 0.3}, {1.0, 0.0, 0.5});
  builder.room(glm::dvec3(0.0), glm::dvec3(1.0), {wall, wall, wall, wall, wall, wall});
  return {builder.model()};
}

std::vector<Finding> dark_channel_law(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_radiosity(lights[0], 0, 5, 1 / 0.5, kPermille, findings, 0);
  expect_radiosity(lights[0], 0, 5, 0, 0, findings, 1);
  expect_radiosity(lights[0], 0, 5, 0.5 / 0.7, kPermille, findings, 2);
  expect_no_leak(lights[0], findings);
  return findings;
}

}  // namespace

std::vector<HardCase> furnace_cases() {
  CaseSettings one_a_face;
  one_a_face.elements = 6;
  CaseSettings loans = one_a_face;
  loans.overshoot = true;
  loans.elements = 96;
  return {
      {"FurnaceOfReflectance0999", "A thousand bounces, one element a face.",
       "A closed room of one reflectance in which everything emits E has B = E / (1 - reflectance) "
       "everywhere "
       "(each point sees B in all directions).",
       furnace<999, 1000>, one_a_face, furnace_law<999, 1000>},
      {"FurnaceOfReflectance65535Of65536",
       "Hundreds of thousands of bounces; headroom leaves 16,220 units of flux for all that is emitted.",
       "The same law. What is left is at most one unit, 1/16,220; and an element absorbs its first unit at "
       "once, since absorbed is received less the floor of what is reflected, so an element is at most one "
       "unit in the 2703 that it emits ahead of its time: 0.04 %.",
       furnace<65535, 65536>, one_a_face, furnace_law<65535, 65536>},
      {"LoansAtReflectance099", "Overshooting lends flux while all headroom is in use.",
       "The same law: loans are repaid in full.", furnace<99, 100>, loans, furnace_law<99, 100>},
      {"OneChannelDark",
       "Two channels glow, the third has no light at all.",
       "Channels do not mix: B = E / (1 - reflectance) in each, exactly 0 in the dark one.",
       furnace_with_a_dark_channel,
       {},
       dark_channel_law},
  };
}

}  // namespace fixrad::host

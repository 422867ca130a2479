// SPDX-License-Identifier: MIT
// Lamps that are tiny, unequal, shut in, or face the dark.
#include "tests/lib/closed_forms.h"
#include "tests/stability/hard_scenes.h"
#include "tests/stability/laws.h"

namespace fixrad::host {
namespace {

constexpr double kPermille = 0.001;
constexpr double kMillionth = 0.00244948974;  // side of a square of 6e-6: the room's walls are 6
constexpr double kRatio = 1e6;

template <int Percent>
std::vector<Model> room_with_tiny_lamp() {
  return {room_with_inset_lamp(kMillionth, Percent / 100.0)};
}

std::vector<Finding> tiny_lamp_in_a_grey_room(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_conserved(lights[0], 0.5, kPermille, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

std::vector<Finding> tiny_lamp_in_a_black_room(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  const double floor = point_to_parallel({-0.5, 0.5, -0.5, 0.5}, 1);
  expect_received(lights[0], 2, "received by the floor, of what is emitted", floor, kPermille, findings);
  expect_received(lights[0], 0, "received by a wall", (1 - floor) / 4, kPermille, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

// Two rooms, a metre apart, that know nothing of each other but the unit of flux.
std::vector<Model> rooms_of_unequal_light() {
  ModelBuilder builder;
  const std::uint32_t dim = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  const std::uint32_t bright = builder.material(glm::dvec3(0.5), glm::dvec3(kRatio));
  builder.room({0, 0, 0}, {1, 1, 1}, {dim, dim, dim, dim, dim, dim});
  builder.room({2, 0, 0}, {3, 1, 1}, {bright, bright, bright, bright, bright, bright});
  return {builder.model()};
}

std::vector<Finding> unequal_light(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_radiosity(lights[0], 0, 5, 2, 0.02, findings);
  expect_radiosity(lights[0], 6, 11, 2 * kRatio, 0.02, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

// Two lamps below, a wall above; all black.
constexpr Rectangle kLampA = {0, 1, 0, 1}, kLampB = {2, 3, 0, 1}, kWall = {0, 3, 0, 1};

std::vector<Model> lamps_and_a_dark_wall() {
  ModelBuilder builder;
  const std::uint32_t one = builder.material(glm::dvec3(0.0), glm::dvec3(1.0));
  const std::uint32_t three = builder.material(glm::dvec3(0.0), glm::dvec3(3.0));
  const std::uint32_t dark = builder.material(glm::dvec3(0.0));
  square(builder, {0.5, 0, 0.5}, 1, true, one);
  square(builder, {2.5, 0, 0.5}, 1, true, three);
  builder.polygon({{0, 1, 0}, {3, 1, 0}, {3, 1, 1}, {0, 1, 1}}, dark);
  return {builder.model()};
}

std::vector<Finding> light_on_a_dark_wall(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  const double part =
      0.25 * parallel_form_factor(kLampA, kWall, 1) + 0.75 * parallel_form_factor(kLampB, kWall, 1);
  expect_received(lights[0], 2, "received by the wall", part, 2 * kPermille, findings);
  findings.push_back({"escaped", lights[0].escaped[0], 1 - part, 2 * kPermille});
  expect_radiosity(lights[0], 2, 2, 0, 0, findings);
  return findings;
}

// A glowing cell, walled in, inside a room.
std::vector<Model> lamp_behind_walls() {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.room(glm::dvec3(0.0), glm::dvec3(4.0), {wall, wall, wall, wall, wall, wall});
  builder.box({1.4, 0.9, 1.4}, {2.6, 2.1, 2.6}, 0.0, wall);
  builder.room({1.5, 1, 1.5}, {2.5, 2, 2.5}, {lamp, lamp, lamp, lamp, lamp, lamp});
  return {builder.model()};
}

std::vector<Finding> darkness_outside(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  double outside = 0;
  for (std::uint32_t face = 0; face < 12; ++face) {
    outside += face_received(lights[0], face);
  }
  findings.push_back({"received outside the cell", outside, 0, 0});
  expect_radiosity(lights[0], 12, 17, 2, kPermille, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

}  // namespace

std::vector<HardCase> lamp_cases() {
  CaseSettings to_the_last_unit;
  to_the_last_unit.elements = 12;
  to_the_last_unit.stop = Fraction::from_raw(0);
  CaseSettings fine;
  fine.cells = {{6, 6}};
  fine.flux_per_eye = Fraction::from_raw(1u << 20);
  return {
      {"LampOfAMillionthOfTheRoom",
       "The lamp is 40 grid units wide in a room of 16,367.",
       "In a closed room of one reflectance all light that leaves surfaces is 1 / (1 - reflectance) times "
       "what "
       "is emitted, since all of it arrives: no form factor matters. The walls' radiosity is some 200 units "
       "of "
       "2^-27 of the lamp's, rounded down: their flux keeps the law to a permille, their radiosity to that "
       "unit.",
       room_with_tiny_lamp<50>,
       {},
       tiny_lamp_in_a_grey_room},
      {"LampOfAMillionthOnBlackWalls",
       "The same lamp, direct light alone.",
       "Form factor from a point to the floor under it (parallel rectangle, closed form), and by symmetry a "
       "quarter of the rest to each wall.",
       room_with_tiny_lamp<0>,
       {},
       tiny_lamp_in_a_black_room},
      {"LampsOfAMillionToOne",
       "Two closed rooms, one a million times brighter: the dim one owns 531 units of flux.",
       "Both are furnaces: B = E / (1 - reflectance). The dim room's twelve faces hold 88 units each of "
       "what they emit, and absorb the first one at once: within 2 %, as is the noise of so few shots.",
       rooms_of_unequal_light, to_the_last_unit, unequal_light},
      {"TwoLampsAndADarkWall", "Nothing reflects; most light leaves the scene.",
       "The wall receives the lamps' form factors (parallel rectangles, closed form), weighted by their "
       "flux; "
       "the rest escapes; a black wall shows nothing.",
       lamps_and_a_dark_wall, fine, light_on_a_dark_wall},
      {"NoPathFromTheLampToTheRoom",
       "The lamp is walled in.",
       "The room receives exactly nothing; the cell is a furnace.",
       lamp_behind_walls,
       {},
       darkness_outside},
  };
}

}  // namespace fixrad::host

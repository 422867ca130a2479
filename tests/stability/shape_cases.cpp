// SPDX-License-Identifier: MIT
// Faces that are slivers, touch, overlap, nearly touch or pierce each other.
#include "tests/stability/hard_scenes.h"
#include "tests/stability/laws.h"

namespace fixrad::host {
namespace {

constexpr double kPermille = 0.001;
constexpr double kReflectance = 0.6;

// A furnace whose floor has a strip of one grid unit by 16,367 across it.
std::vector<Model> furnace_with_a_sliver() {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  const std::uint32_t strip = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  const double s = kGridRoom, a = 8000, b = 8001;
  builder.polygon({{0, 0, 0}, {0, s, 0}, {0, s, s}, {0, 0, s}}, wall);
  builder.polygon({{s, 0, 0}, {s, 0, s}, {s, s, s}, {s, s, 0}}, wall);
  builder.polygon({{0, s, 0}, {s, s, 0}, {s, s, s}, {0, s, s}}, wall);
  builder.polygon({{0, 0, 0}, {a, 0, 0}, {b, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0}}, wall);
  builder.polygon({{0, 0, s}, {0, s, s}, {s, s, s}, {s, 0, s}, {b, 0, s}, {a, 0, s}}, wall);
  builder.polygon({{0, 0, 0}, {0, 0, s}, {a, 0, s}, {a, 0, 0}}, wall);
  builder.polygon({{b, 0, 0}, {b, 0, s}, {s, 0, s}, {s, 0, 0}}, wall);
  builder.polygon({{a, 0, 0}, {a, 0, s}, {b, 0, s}, {b, 0, 0}}, strip);
  return {builder.model()};
}

std::vector<Finding> sliver_law(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_conserved(lights[0], 0.5, kPermille, findings);
  expect_radiosity(lights[0], 0, 6, 2, 0.02, findings);
  expect_radiosity(lights[0], 7, 7, 2, 0.1, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

std::vector<Finding> conserved(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_conserved(lights[0], kReflectance, kPermille, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

// Boxes in a lit room, turned into each other by half a turn about the line y = z = 8000.
constexpr double kMiddle = 8000;

std::vector<Model> boxes_with_an_edge_in_common() {
  ModelBuilder builder;
  lit_grid_room(builder, kReflectance);
  builder.box({4000, 5000, 5000}, {12000, kMiddle, kMiddle}, 0.0, 0);
  builder.box({4000, kMiddle, kMiddle}, {12000, 11000, 11000}, 0.0, 0);
  return {builder.model()};
}

// Faces of the second box as half a turn about x finds them: -x +x stay, -y and +y, -z and +z change places.
std::vector<Finding> half_turn_law(const std::vector<Light>& lights) {
  std::vector<Finding> findings = conserved(lights);
  constexpr std::uint32_t kTurned[6] = {0, 1, 3, 2, 5, 4};
  for (std::uint32_t f = 0; f < 6; ++f) {
    const double a = face_radiosity(lights[0], 6 + f), b = face_radiosity(lights[0], 12 + kTurned[f]);
    findings.push_back({"radiosity of face " + std::to_string(6 + f) + " over its image", a / b, 1, 0.05});
  }
  return findings;
}

std::vector<Model> boxes_with_a_vertex_in_common() {
  ModelBuilder builder;
  lit_grid_room(builder, kReflectance);
  builder.box({5000, 5000, 5000}, {kMiddle, kMiddle, kMiddle}, 0.0, 0);
  builder.box({kMiddle, kMiddle, kMiddle}, {11000, 11000, 11000}, 0.0, 0);
  return {builder.model()};
}

// A plate in the plane of the floor that covers a part of it.
std::vector<Model> floor_with_a_plate_in_its_plane() {
  ModelBuilder builder;
  lit_grid_room(builder, kReflectance);
  square(builder, {kMiddle, 0, kMiddle}, 5000, true, builder.material(glm::dvec3(kReflectance)));
  return {builder.model()};
}

// Everything glows; a box floats a grid unit over the floor. Elements end at its outline.
std::vector<Model> furnace_with_a_slit() {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.room(glm::dvec3(0.0), {16000, 16000, 16000}, {wall, wall, wall, wall, wall, wall});
  builder.box({4000, 1, 4000}, {12000, 6000, 12000}, 0.0, wall);
  return {builder.model()};
}

std::vector<Finding> slit_law(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_conserved(lights[0], 0.5, kPermille, findings);
  expect_radiosity(lights[0], 0, 11, 2, 0.02, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

std::vector<Model> boxes_that_pierce_each_other() {
  ModelBuilder builder;
  lit_grid_room(builder, kReflectance);
  builder.box({4000, 3000, 4000}, {10000, 8000, 10000}, 0.0, 0);
  builder.box({6000, 1000, 6000}, {9000, 12000, 13000}, 0.4, 0);
  builder.box({2000, 5000, 5000}, {14000, 6000, 6000}, 0.9, 0);
  return {builder.model()};
}

}  // namespace

std::vector<HardCase> shape_cases() {
  CaseSettings slit;
  slit.cells = {{8, 8}};
  const char* conservation =
      "Closed and of one reflectance: all light that leaves surfaces is 1 / (1 - reflectance) times what is "
      "emitted, and nothing escapes, to the unit";
  return {
      {"SliverOfOneTo16367",
       "A strip of the floor, one grid unit wide, in elements as long as the others.",
       "A furnace: B = E / (1 - reflectance) on every face, the strip included. Rows of samples meet the "
       "strip or miss "
       "it; over all shots they must do so in proportion to its area.",
       furnace_with_a_sliver,
       {},
       sliver_law},
      {"BoxesTouchAtAnEdge",
       "Four faces meet at one edge.",
       std::string(conservation) +
           "; half a turn takes the scene into itself, so faces and their images are equal.",
       boxes_with_an_edge_in_common,
       {},
       half_turn_law},
      {"BoxesTouchAtAVertex",
       "Six faces meet at one vertex.",
       std::string(conservation) + ".",
       boxes_with_a_vertex_in_common,
       {},
       conserved},
      {"CoplanarFacesOverlap",
       "Of two faces in one plane either may be seen, at every point exactly one.",
       std::string(conservation) + ", whoever is seen.",
       floor_with_a_plate_in_its_plane,
       {},
       conserved},
      {"GapOfOneGridUnit", "A box floats a 16,367th of the room over its floor; both sides of the slit emit.",
       "A furnace: B = E / (1 - reflectance) on every face, in the slit too.", furnace_with_a_slit, slit,
       slit_law},
      {"BoxesPierceEachOther",
       "Three bodies run through each other; parts of faces lie inside others.",
       std::string(conservation) + ".",
       boxes_that_pierce_each_other,
       {},
       conserved},
  };
}

}  // namespace fixrad::host

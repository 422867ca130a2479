// SPDX-License-Identifier: MIT
// Scenes of any extent, anywhere on the grid, turned and mirrored, and just as large as the memory.
#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "host_sim/io/obj_reader.h"
#include "tests/report/scratch_folder.h"
#include "tests/stability/hard_scenes.h"
#include "tests/stability/laws.h"
#include "tests/stability/obj_text.h"
#include "tests/stability/symmetries.h"

namespace fixrad::host {
namespace {

constexpr double kPermille = 0.001;

// As a user has it: a file of this extent, read and put on the grid.
Model read_back(Model model, double scale, double offset) {
  for (glm::dvec3& p : model.positions) {
    p = scale * p + offset;
  }
  const testing::ScratchFolder folder;
  return read_obj(write_obj(model, (folder / "").string(), "scaled"));
}

Model room_of_side_one() {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material({0.5, 0.7, 0.3}, {1.0, 2.0, 3.0});
  builder.room(glm::dvec3(0.0), glm::dvec3(1.0), {wall, wall, wall, wall, wall, wall});
  builder.box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.75}, 0.0, wall);
  return builder.model();
}

std::vector<Model> rooms_of_all_extents() {
  const Model room = room_of_side_one();
  return {read_back(room, 1, 0), read_back(room, 1e-4, 0), read_back(room, 1e6, 0), read_back(room, 1, 1e6)};
}

double values_that_differ(const Light& a, const Light& b) {
  double count = 0;
  for (std::size_t i = 0; i < a.received.size(); ++i) {
    count += a.received[i] == b.received[i] ? 0 : 1;
  }
  return count;
}

std::vector<Finding> same_at_all_extents(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  for (const Light& light : lights) {
    expect_radiosity(light, 0, 11, 2, 0.05, findings, 0);
    expect_radiosity(light, 0, 11, 2 / 0.3, 0.05, findings, 1);
    expect_radiosity(light, 0, 11, 3 / 0.7, 0.05, findings, 2);
    expect_no_leak(light, findings);
    findings.push_back({"elements that receive another flux than in the room of side 1",
                        values_that_differ(light, lights[0]), 0, 0});
  }
  return findings;
}

// A furnace of 160 grid units in one corner of the grid; what makes the grid so coarse is a black body in the
// other corner that no light reaches.
template <bool InTheFarCorner>
std::vector<Model> furnace_in_a_corner() {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  const std::uint32_t black = builder.material(glm::dvec3(0.0));
  const double s = kGridRoom, at = InTheFarCorner ? s - 160 : 0, other = InTheFarCorner ? 0 : s - 50;
  builder.room(glm::dvec3(at), glm::dvec3(at + 160), {wall, wall, wall, wall, wall, wall});
  builder.box(glm::dvec3(other), glm::dvec3(other + 50), 0.0, black);
  return {builder.model()};
}

std::vector<Finding> corner_law(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_radiosity(lights[0], 0, 5, 2, 0.005, findings);
  expect_radiosity(lights[0], 6, 11, 0, 0, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

std::vector<Model> room_with_boxes() {
  ModelBuilder builder;
  lit_grid_room(builder, 0.5);
  builder.box({3000, 0, 3000}, {6000, 7000, 6000}, 0.3, 0, true);
  builder.box({9000, 4000, 9000}, {13000, 7000, 13000}, 0.8, 0);
  return {builder.model()};
}

std::vector<Finding> capacity_law(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_conserved(lights[0], 0.5, kPermille, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

Model furnished_room() {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.3), glm::dvec3(1.0));
  const std::uint32_t body = builder.material(glm::dvec3(0.7));
  builder.room(glm::dvec3(0.0), {kGridRoom, 9000, 12000}, {lamp, wall, wall, wall, wall, wall});
  builder.box({8000, 1000, 2000}, {11000, 5000, 5000}, std::atan2(3, 4), body);
  return builder.model();
}

std::vector<Model> all_images_of_a_closed_room() {
  return images_of(furnished_room());
}

std::vector<Model> all_images_of_an_open_room() {
  Model model = furnished_room();
  model.faces.erase(model.faces.begin() + 3);  // the ceiling
  model.file_faces = model.faces.size();
  return images_of(model);
}

// The largest difference of a face's radiosity from that of the first light, over the mean radiosity.
double largest_difference(const Light& a, const Light& b, std::uint32_t faces) {
  double largest = 0, mean = 0;
  for (std::uint32_t f = 0; f < faces; ++f) {
    largest = std::max(largest, std::abs(face_radiosity(a, f) - face_radiosity(b, f)));
    mean += face_radiosity(b, f) / faces;
  }
  return largest / mean;
}

template <std::uint32_t Faces, bool IsClosed>
std::vector<Finding> symmetric(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  double turned = 0, faces = 0, gone = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    faces = std::max(faces, largest_difference(lights[i], lights[0], Faces));
    gone = std::max(gone, std::abs(lights[i].escaped[0] - lights[0].escaped[0]));
    turned += is_rotation(i) ? values_that_differ(lights[i], lights[0]) : 0;
    if (IsClosed) {
      expect_no_leak(lights[i], findings);
    }
  }
  constexpr double kNoise = 0.01;  // of the mean, a face's by 150 elements with 32 lunes
  findings.push_back(
      {"largest difference of a face from the first image, over the mean", faces, 0, 2 * kNoise});
  findings.push_back({"largest difference of what escapes", gone, 0, IsClosed ? 0 : 0.002});
  findings.push_back({"elements of the 24 rotations that receive another flux", turned, 0, 0});
  return findings;
}

}  // namespace

std::vector<HardCase> size_cases() {
  CaseSettings full;
  full.spans_to_the_last = true;
  CaseSettings fine;
  fine.flux_per_row = fraction(1, 40000);
  return {
      {"ExtentsFromTenThousandthToAMillion",
       "The same room with sides of 1, 1e-4 and 1e6, and at 1e6 from the origin, through the OBJ reader.",
       "Radiosity has no scale: B = E / (1 - reflectance) in each, and every element receives the same flux "
       "to the "
       "unit, since the grid is the same.",
       rooms_of_all_extents,
       {},
       same_at_all_extents},
      {"EverythingInTheNearCornerOfTheGrid",
       "The room has 160 of 16,383 grid units: an outlier spoils the grid.",
       "A furnace; the outlier stays black; closed, so nothing escapes.",
       furnace_in_a_corner<false>,
       {},
       corner_law},
      {"EverythingInTheFarCornerOfTheGrid",
       "The same in the corner of the largest coordinates.",
       "The same.",
       furnace_in_a_corner<true>,
       {},
       corner_law},
      {"CapacityToTheLastSlot",
       "Vertices, faces, elements and spans of the solver are exactly what the scene needs.",
       "Closed and of one reflectance: all light that leaves surfaces is 1 / (1 - reflectance) times what is "
       "emitted.",
       room_with_boxes, full, capacity_law},
      {"SymmetriesOfAClosedRoom", "Every axis permutation, mirror and rotation by 90 degrees of one scene.",
       "Nothing escapes from any. Rotations leave every product that the core takes as it was: the same flux "
       "to the unit. Mirrors turn the rows the other way: both are within the noise of sampling of the same "
       "solution, 1 % of the mean for a face, so within 2 % of each other.",
       all_images_of_a_closed_room, fine, symmetric<12, true>},
      {"SymmetriesOfAnOpenRoom", "The same without a ceiling.",
       "As much escapes from each, to the unit under rotations; mirrored, within 0.2 % of what is emitted.",
       all_images_of_an_open_room, fine, symmetric<11, false>},
  };
}

const std::vector<HardCase>& hard_cases() {
  static const std::vector<HardCase> cases = [] {
    std::vector<HardCase> all;
    for (const auto& some : {furnace_cases(), lamp_cases(), shape_cases(), view_cases(), size_cases()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return cases;
}

}  // namespace fixrad::host

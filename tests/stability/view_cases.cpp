// SPDX-License-Identifier: MIT
// Views in which something lies exactly where a comparison is decided.
#include "tests/lib/closed_forms.h"
#include "tests/stability/hard_scenes.h"
#include "tests/stability/laws.h"

namespace fixrad::host {
namespace {

constexpr double kPermille = 0.001;

// Directions to vertices are rounded to 14 bits: what is seen edge-on may have that width.
constexpr double kDirection = 1.0 / (1 << 14);

// Lengths are grid units: the wall's far corner is kGridRoom away.
constexpr double kSide = 8000;

// A square lamp, and at its edge a wall of which the lower half lies under the lamp's plane.
std::vector<Model> wall_through_the_horizon() {
  ModelBuilder builder;
  const std::uint32_t lamp = builder.material(glm::dvec3(0.0), glm::dvec3(1.0));
  const std::uint32_t wall = builder.material(glm::dvec3(0.0));
  const double s = 1;
  builder.polygon({{0, 0, 0}, {0, 0, s}, {s, 0, s}, {s, 0, 0}}, lamp);
  builder.polygon({{0, -s, 0}, {0, s, 0}, {0, s, s}, {0, -s, s}}, wall);
  return {builder.model()};
}

std::vector<Finding> half_a_wall(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_received(lights[0], 1, "received by the wall", kPerpendicularUnitSquares, kPermille, findings);
  findings.push_back({"escaped", lights[0].escaped[0], 1 - kPerpendicularUnitSquares, kPermille});
  findings.push_back({"lost to back faces", lights[0].back[0], 0, 0});
  return findings;
}

// A lamp of four grid units round (x, z) = kSide, its middle on a grid point; it looks up. Black. Another
// one, added last, sends as much into the void, so that neither has more than half of all flux: an element
// with more has several eyes.
std::uint32_t point_lamp(ModelBuilder& builder) {
  const std::uint32_t lamp = builder.material(glm::dvec3(0.0), glm::dvec3(1.0));
  square(builder, {kSide, 0, kSide}, 4, true, lamp);
  return builder.material(glm::dvec3(0.0));
}

constexpr double kHalf = 0.5;

// Over all: a black square ceiling at `height` of the grid's full width; and the other lamp.
void ceiling(ModelBuilder& builder, double height, std::uint32_t material) {
  const double s = kGridRoom;
  builder.polygon({{0, height, 0}, {s, height, 0}, {s, height, s}, {0, height, s}}, material);
  square(builder, {kSide, 0, kSide}, 4, false, builder.material(glm::dvec3(0.0), glm::dvec3(1.0)));
}

Rectangle seen(double x0, double x1, double z0, double z1) {
  return {x0 - kSide, x1 - kSide, z0 - kSide, z1 - kSide};
}

// A box one of whose vertical edges stands over the lamp's middle.
constexpr double kBottom = 2000, kTop = 6000, kWidth = 4000, kCeiling = 12000;

std::vector<Model> box_with_an_edge_over_the_eye() {
  ModelBuilder builder;
  const std::uint32_t black = point_lamp(builder);
  builder.box({kSide, kBottom, kSide}, {kSide + kWidth, kTop, kSide + kWidth}, 0.0, black);
  ceiling(builder, kCeiling, black);
  return {builder.model()};
}

// The box hides of the ceiling what its bottom hides, a rectangle that starts over the lamp.
std::vector<Finding> quarter_hidden(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  const double bottom = point_to_parallel({0, kWidth, 0, kWidth}, kBottom);
  const double reach = kWidth * kCeiling / kBottom;  // beyond the ceiling's corner
  const double far = kGridRoom - kSide;
  static_assert(kWidth * kCeiling / kBottom > kGridRoom - kSide);
  const double open =
      point_to_parallel(seen(0, kGridRoom, 0, kGridRoom), kCeiling) -
      point_to_parallel({0, reach < far ? reach : far, 0, reach < far ? reach : far}, kCeiling);
  expect_received(lights[0], 3, "received by the box's bottom", kHalf * bottom, 2 * kPermille, findings);
  expect_received(lights[0], 1, "received by the side x = eye", 0, kDirection, findings);
  expect_received(lights[0], 5, "received by the side z = eye", 0, kDirection, findings);
  expect_received(lights[0], 7, "received by the ceiling", kHalf * open, 2 * kPermille, findings);
  return findings;
}

// A plate on edge over the lamp: the eye lies in its plane.
std::vector<Model> plate_on_edge() {
  ModelBuilder builder;
  const std::uint32_t black = point_lamp(builder);
  builder.polygon({{kSide, 1000, 4000}, {kSide, 9000, 4000}, {kSide, 9000, 12000}, {kSide, 1000, 12000}},
                  black);
  ceiling(builder, kCeiling, black);
  return {builder.model()};
}

std::vector<Finding> nothing_of_the_plate(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  const double open = point_to_parallel(seen(0, kGridRoom, 0, kGridRoom), kCeiling);
  expect_received(lights[0], 1, "received by the plate on edge", 0, kDirection, findings);
  findings.push_back({"lost to back faces", lights[0].back[0], 0, 0});
  expect_received(lights[0], 2, "received by the ceiling", kHalf * open, kPermille, findings);
  return findings;
}

// A furnace with a panel of 64 x 64 elements in its ceiling, a 25th of the room wide: one lune of the coarser
// tables hides all of it.
std::vector<Model> furnace_with_a_fine_panel() {
  Model model = room_with_inset_lamp(0.04, 0.5);
  for (Material& material : model.materials) {
    material.emission = glm::dvec3(1.0);
  }
  return {model};
}

std::vector<Finding> fine_panel_law(const std::vector<Light>& lights) {
  std::vector<Finding> findings;
  expect_conserved(lights[0], 0.5, kPermille, findings);
  expect_radiosity(lights[0], 0, 8, 2, 0.02, findings);
  expect_radiosity(lights[0], 9, 9, 2, 0.05, findings);
  expect_no_leak(lights[0], findings);
  return findings;
}

}  // namespace

std::vector<HardCase> view_cases() {
  CaseSettings straddling;
  straddling.cells = {{8, 8}, {1, 1}};
  straddling.flux_per_eye = Fraction::from_raw(1u << 20);
  CaseSettings one_eye;
  one_eye.cells = {{1, 1}};
  one_eye.flux_per_eye = Fraction::from_raw(0xffffffffu);
  one_eye.lunes = 128;
  CaseSettings panel;
  panel.cells = {{6, 6}, {6, 6}, {6, 6}, {6, 6}, {6, 6}, {4, 4}, {4, 4}, {4, 4}, {4, 4}, {64, 64}};
  return {
      {"ElementStraddlesTheShootersPlane", "One element reaches from under the shooter's plane to over it.",
       "Only what is over the plane receives: the form factor of unit squares at right angles (closed form); "
       "the rest "
       "escapes.",
       wall_through_the_horizon, straddling, half_a_wall},
      {"EyeOnTheLineOfAnEdge", "An edge of a box points at the eye; two of its sides are seen edge-on.",
       "The lamp is a point: its form factor to the bottom is closed (parallel rectangle), 0 to the two "
       "sides, and the "
       "ceiling receives what the bottom does not hide.",
       box_with_an_edge_over_the_eye, one_eye, quarter_hidden},
      {"FaceSeenEdgeOn", "The eye lies exactly in the plane of a face.",
       "The face receives nothing and hides nothing, but for 2^-14, to which directions are rounded: the "
       "ceiling has the closed form of a point and a rectangle.",
       plate_on_edge, one_eye, nothing_of_the_plate},
      {"ThousandsOfElementsBehindOnePixel", "4096 elements share one row of samples, or none.",
       "A furnace: the panel has B = E / (1 - reflectance) as all else.", furnace_with_a_fine_panel, panel,
       fine_panel_law},
  };
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// The closed form in place of the sampled entries of lamps.
#include "lib/form_factor/direct_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/meshing/gather_points.h"
#include "lib/form_factor/engine.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

constexpr double kLampSide = 0.06, kLampHeight = 2.0;

// A floor of 4 m under a small square lamp, with a plate half way up that reaches from x = `plate` to 1.
Model lamp_over_floor(double plate, double lamp_side = kLampSide) {
  ModelBuilder builder;
  const std::uint32_t grey = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.0), glm::dvec3(100.0));
  builder.polygon({{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}}, grey);
  const double r = lamp_side / 2, h = kLampHeight;
  builder.polygon({{-r, h, -r}, {r, h, -r}, {r, h, r}, {-r, h, r}}, lamp);
  if (plate < 1) {
    builder.polygon({{plate, 1, -1}, {plate, 1, 1}, {1, 1, 1}, {1, 1, -1}}, grey);
  }
  return builder.model();
}

class Row {
 public:
  explicit Row(const Model& model) : solution_(model, options()) {}

  State& state() { return solution_.state(); }

  // From a point of the floor, which is face 0.
  EyePoint eye_at(double x, double z) const {
    const GatherPoint point = gather_point(solution_.device(), 0, {x, 0, z});
    return {vec(point.position), 0, 0};
  }
  // Where that is, metres.
  glm::dvec3 position(const EyePoint& eye) const {
    const Grid& grid = solution_.device().grid;
    return glm::dvec3(eye.position.x, eye.position.y, eye.position.z) / (kEyeScale * grid.scale) +
           grid.origin;
  }

  void sample(const EyePoint& eye, bool is_corrected) {
    clear(state().row);
    ASSERT_EQ(lune_rows(state().scene, *lune_table(64), {eye, kRowOne, true}, state().work, state().row),
              Status::ok);
    if (is_corrected) {
      correct_direct_light(state().scene, eye, state().work, state().row);
    }
  }

  // Part of the hemisphere that emitting elements fill.
  double of_lamps() {
    const Scene& scene = state().scene;
    double sum = 0;
    for (std::uint16_t j = 0; j < scene.element_count; ++j) {
      sum += scene.materials[scene.elements[j].material].emission[0] > 0 ? state().row.share[j] : 0u;
    }
    return sum / kRowOne;
  }

  std::uint64_t total() {
    std::uint64_t sum = state().row.escaped + state().row.back;
    for (std::uint16_t j = 0; j < state().scene.element_count; ++j) {
      sum += state().row.share[j];
    }
    return sum;
  }

 private:
  static SolveOptions options() {
    SolveOptions options;
    options.elements = 40;
    return options;
  }

  Solution solution_;
};

// cos cos A / (pi r^2); the lamp's size adds (side / r)^2 of it, a thousandth.
double small_square_factor(glm::dvec3 from) {
  const glm::dvec3 way = glm::dvec3(0, kLampHeight, 0) - from;
  const double r2 = glm::dot(way, way), cosine = way.y / std::sqrt(r2);
  return cosine * cosine * kLampSide * kLampSide / (std::acos(-1.0) * r2);
}

TEST(DirectLight, OfASmallLampIsItsClosedFormWhereverRowsFall) {
  Row row(lamp_over_floor(1));
  double worst_sampled = 0;
  for (int i = 0; i < 60; ++i) {
    const EyePoint eye = row.eye_at(-1.5 + 0.05 * i, -1.2 + 0.037 * i);
    const double expected = small_square_factor(row.position(eye));
    row.sample(eye, false);
    worst_sampled = std::max(worst_sampled, std::abs(row.of_lamps() / expected - 1));
    row.sample(eye, true);
    // Its corners are rounded to the grid, 1/246 of its side; entries to 2^-20.
    ASSERT_NEAR(row.of_lamps(), expected, 0.005 * expected + 1.0 / kRowOne) << i;
  }
  EXPECT_GT(worst_sampled, 0.2) << "rows alone would do";
}

TEST(DirectLight, OfALampThatAPlateCoversIsWhatItLeavesFree) {
  // Seen from under its border the plate covers the lamp's part beyond twice that border.
  for (const double border : {-0.05, -0.0075, 0.0, 0.0075, 0.05}) {
    Row row(lamp_over_floor(border));
    const EyePoint eye = row.eye_at(0, 0);
    const glm::dvec3 from = row.position(eye);
    const double shadow = from.x + (border - from.x) * kLampHeight;  // on the lamp's plane; the eye is low
    const double free = std::clamp((shadow + kLampSide / 2) / kLampSide, 0.0, 1.0);
    row.sample(eye, true);
    EXPECT_NEAR(row.of_lamps() / small_square_factor(from), free, 0.05) << border;
    EXPECT_EQ(row.total(), kRowOne);
  }
}

TEST(DirectLight, KeepsTheSumOfEveryRow) {
  for (const Model& model : {lamp_over_floor(0.0), cornell(), random_closed_room(6), random_open_room(2)}) {
    Row row(model);
    const Scene& scene = row.state().scene;
    for (std::uint16_t e = 0; e < scene.element_count; ++e) {
      row.sample(element_eye(scene, e), true);
      ASSERT_EQ(row.total(), kRowOne) << "element " << e;
    }
  }
}

TEST(DirectLight, LeavesALampThatSpansManyRowsAsSampled) {
  Row row(lamp_over_floor(1, 3.0));
  const EyePoint eye = row.eye_at(0, 0);
  row.sample(eye, false);
  const double sampled = row.of_lamps();
  row.sample(eye, true);
  EXPECT_GT(sampled, 1.0 / kLargeLamp);
  EXPECT_EQ(row.of_lamps(), sampled);
}

TEST(DirectLight, LeavesRowsThatSeeNoLampAsTheyAre) {
  Row row(lamp_over_floor(1));
  const Scene& scene = row.state().scene;
  for (std::uint16_t e = 0; e < scene.element_count; ++e) {
    if (scene.materials[scene.elements[e].material].emission[0] == 0) {
      continue;
    }
    row.sample(element_eye(scene, e), false);
    const std::vector<std::uint32_t> before(row.state().row.share,
                                            row.state().row.share + scene.element_count);
    row.sample(element_eye(scene, e), true);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), row.state().row.share)) << "element " << e;
  }
}

}  // namespace
}  // namespace fixrad::host

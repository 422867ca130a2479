// SPDX-License-Identifier: MIT
#include "host_sim/meshing/discontinuity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/io/obj_reader.h"
#include "host_sim/meshing/critical_lines.h"
#include "host_sim/simulate/adaptive_mesh.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"
#include "tests/meshing/shading_error.h"

namespace fixrad::host {
namespace {

struct Cut {
  Cut(Model m, std::uint32_t elements, const DiscontinuityOptions& options = {})
      : model(std::move(m)),
        prepared(prepare(model)),
        meshing(make_discontinuity(prepared, elements, elements / 4, options)) {}
  Cut(const Cut&) = delete;
  Cut& operator=(const Cut&) = delete;

  Model model;
  PreparedScene prepared;
  Meshing meshing;
};

Model scene(const char* name) {
  return read_obj(std::string(FIXRAD_SOURCE_DIR "/scenes/") + name + ".obj");
}

/// A floor of 8 m, a square lamp of 1 m at 3 m, a square of 1.5 m half way up.
Model square_under_a_square_lamp() {
  ModelBuilder builder;
  const std::uint32_t grey = builder.material(glm::dvec3(0.5));
  const std::uint32_t bright = builder.material(glm::dvec3(0.5), glm::dvec3(10.0));
  builder.polygon({{-4, 0, -4}, {-4, 0, 4}, {4, 0, 4}, {4, 0, -4}}, grey);
  builder.polygon({{0.5, 3, -0.5}, {0.5, 3, 0.5}, {-0.5, 3, 0.5}, {-0.5, 3, -0.5}}, bright);
  builder.polygon({{-0.75, 1.5, -0.75}, {-0.75, 1.5, 0.75}, {0.75, 1.5, 0.75}, {0.75, 1.5, -0.75}}, grey);
  return builder.model();
}

/// Distance from a point of a face to the nearest side of an element, grid units.
double distance_to_sides(const FaceFrame& frame, const FaceElements& face, const glm::dvec3& p) {
  double nearest = 1e9;
  for (const CellElement& e : face.elements) {
    for (std::size_t k = 0; k < e.outline.size(); ++k) {
      const glm::dvec3 a = frame.to_grid(e.outline[k]);
      const glm::dvec3 d = frame.to_grid(e.outline[(k + 1) % e.outline.size()]) - a;
      const double along = std::clamp(glm::dot(p - a, d) / std::max(1e-9, glm::dot(d, d)), 0.0, 1.0);
      nearest = std::min(nearest, glm::length(p - a - along * d));
    }
  }
  return nearest;
}

TEST(Discontinuity, ElementsOfACoarseMeshEndAtTheBordersOfUmbraAndPenumbra) {
  DiscontinuityOptions options;
  options.coarse = 0.3;
  const Cut cut(square_under_a_square_lamp(), 150, options);
  const std::vector<CriticalLine> lines = find_critical_lines(cut.prepared);
  ASSERT_EQ(lines.size(), 8u);
  for (const CriticalLine& line : lines) {
    const FaceFrame& frame = cut.prepared.frames[line.face];
    for (const double at : {0.3, 0.4, 0.5, 0.6, 0.7}) {
      const glm::dvec3 p = frame.to_grid(line.a + at * (line.b - line.a));
      EXPECT_LT(distance_to_sides(frame, cut.meshing.faces[line.face], p), 4.0);
    }
  }
}

TEST(Discontinuity, UsesTheElementsThatItMayHaveAndNoMore) {
  for (const std::uint32_t elements : {1u, 40u, 250u, 700u}) {
    const Cut cut(scene("shadow_room"), elements);
    std::size_t count = 0;
    for (const FaceElements& face : cut.meshing.faces) {
      count += face.elements.size();
    }
    EXPECT_EQ(count, cut.meshing.element_count);
    EXPECT_EQ(count, std::max<std::size_t>(elements, cut.prepared.faces.size()));
  }
}

void expect_sound(const Cut& cut, const std::string& name) {
  for (std::size_t f = 0; f < cut.meshing.faces.size(); ++f) {
    const FaceFrame& frame = cut.prepared.frames[f];
    double sum = 0;
    for (const CellElement& e : cut.meshing.faces[f].elements) {
      const double part = area(e.outline) * frame.unit_area();
      double around = 0;
      for (std::size_t k = 0; k < e.outline.size(); ++k) {
        around +=
            glm::distance(frame.to_grid(e.outline[k]), frame.to_grid(e.outline[(k + 1) % e.outline.size()]));
      }
      sum += area(e.outline);
      EXPECT_TRUE(e.depth == 0 || 4 * part > 1.9 * around) << name << " face " << f << ": a sliver";
    }
    EXPECT_NEAR(sum, area(frame.outline), 1e-9 * std::max(1.0, area(frame.outline))) << name << " face " << f;
  }
}

TEST(Discontinuity, ElementsFillTheirFacesWithoutSlivers) {
  for (const char* name : {"shadow_room", "small_lamp", "cornell"}) {
    expect_sound(Cut(scene(name), 250), name);
  }
}

TEST(Discontinuity, ElementsFillTheFacesOfRandomScenesWithoutSlivers) {
  const std::uint32_t seeds = seed_count(6);
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    expect_sound(Cut(random_closed_room(seed), 120), "closed " + std::to_string(seed));
    expect_sound(Cut(random_open_room(seed), 120), "open " + std::to_string(seed));
  }
}

TEST(Discontinuity, IsTheSameEachTime) {
  const Cut first(random_open_room(7), 150), second(random_open_room(7), 150);
  for (std::size_t f = 0; f < first.meshing.faces.size(); ++f) {
    const std::vector<CellElement>& a = first.meshing.faces[f].elements;
    const std::vector<CellElement>& b = second.meshing.faces[f].elements;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t e = 0; e < a.size(); ++e) {
      EXPECT_EQ(a[e].outline, b[e].outline);
    }
  }
}

TEST(Discontinuity, ACoreThatSolvesItLosesNothing) {
  const Cut cut(scene("small_lamp"), 300);
  const DeviceScene device = make_device_scene(cut.prepared, cut.meshing);
  EXPECT_EQ(device.patches.size(), cut.meshing.patch_count);
  Settings settings = lune_settings(16, fraction(1, 100));
  SimulatedDevice solver(sizes_for(device, 0, settings));
  ASSERT_EQ(solver.load(device.view(), settings), Status::ok);
  Status status = Status::ok;
  while (status == Status::ok) {
    status = shoot(solver.state());
  }
  EXPECT_EQ(status, Status::converged);
  const Ledger account = ledger(solver.state(), 0);
  EXPECT_GT(account.emitted, 0);
  EXPECT_EQ(account.imbalance(), 0);
  EXPECT_EQ(account.escaped, 0);
}

TEST(Discontinuity, ShowsHardShadowsBetterThanAnAdaptiveMeshOfAsManyElements) {
  for (const std::uint32_t elements : {250u, 500u}) {
    const Cut cut(scene("shadow_room"), elements);
    const Meshing adaptive = make_adaptive(cut.prepared, elements, elements / 4);
    ASSERT_LE(cut.meshing.element_count, adaptive.element_count);
    const ShadingError own = shading_error(cut.prepared, cut.meshing);
    const ShadingError other = shading_error(cut.prepared, adaptive);
    EXPECT_GE(other.vertices / own.vertices, 1.5) << elements << " elements: " << own.vertices;
    EXPECT_GT(other.elements / own.elements, 0.95) << elements << " elements: " << own.elements;
  }
}

TEST(Discontinuity, OwesThatToTheCriticalLines) {
  DiscontinuityOptions halvings;
  halvings.use_lines = false;
  const Cut cut(scene("shadow_room"), 500), halved(scene("shadow_room"), 500, halvings);
  EXPECT_GE(shading_error(halved.prepared, halved.meshing).vertices /
                shading_error(cut.prepared, cut.meshing).vertices,
            1.4);
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/meshing/critical_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/meshing/direct_light.h"
#include "host_sim/meshing/segment_part.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

constexpr double kGridUnits = 2.0;  // how far a line may be off: its ends are rounded, and so were its causes

struct Traced {
  explicit Traced(Model m)
      : model(std::move(m)), prepared(prepare(model)), lines(find_critical_lines(prepared)) {}
  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;

  glm::dvec3 scene_point(std::uint32_t face, glm::dvec2 st) const {
    return prepared.vertices.grid.to_scene(prepared.frames[face].to_grid(st));
  }
  double tolerance() const { return kGridUnits / prepared.vertices.grid.scale; }

  Model model;
  PreparedScene prepared;
  std::vector<CriticalLine> lines;
};

/// Lines of the plane y = 0, scene units, from the smaller (x, z) to the larger.
struct FloorLine {
  double x0, z0, x1, z1;
  CriticalKind kind;
  int order;
};

std::vector<FloorLine> floor_lines(const Traced& traced) {
  std::vector<FloorLine> lines;
  for (const CriticalLine& line : traced.lines) {
    glm::dvec3 a = traced.scene_point(line.face, line.a), b = traced.scene_point(line.face, line.b);
    if (std::abs(a.y) < traced.tolerance() && std::abs(b.y) < traced.tolerance()) {
      if (std::abs(a.x - b.x) < 2 * traced.tolerance() ? a.z > b.z : a.x > b.x) {
        std::swap(a, b);
      }
      lines.push_back({a.x, a.z, b.x, b.z, line.kind, line.order});
    }
  }
  return lines;
}

bool has_line(const std::vector<FloorLine>& lines, const FloorLine& wanted, double tolerance) {
  return std::any_of(lines.begin(), lines.end(), [&](const FloorLine& l) {
    return std::abs(l.x0 - wanted.x0) <= tolerance && std::abs(l.z0 - wanted.z0) <= tolerance &&
           std::abs(l.x1 - wanted.x1) <= tolerance && std::abs(l.z1 - wanted.z1) <= tolerance &&
           l.kind == wanted.kind && l.order == wanted.order;
  });
}

/// A rectangle parallel to the floor, seen from above or from below.
void plate(ModelBuilder& builder, glm::dvec2 low, glm::dvec2 high, double y, bool looks_up,
           std::uint32_t material) {
  std::vector<glm::dvec3> corners{
      {low.x, y, low.y}, {low.x, y, high.y}, {high.x, y, high.y}, {high.x, y, low.y}};
  if (!looks_up) {
    std::reverse(corners.begin(), corners.end());
  }
  builder.polygon(corners, material);
}

/// An 8 m floor at y = 0, a square lamp of half side `lamp` at y = 3 over its middle.
struct Stage {
  ModelBuilder builder;
  std::uint32_t grey, bright;

  explicit Stage(double lamp) {
    grey = builder.material(glm::dvec3(0.5));
    bright = builder.material(glm::dvec3(0.5), glm::dvec3(10.0));
    plate(builder, {-4, -4}, {4, 4}, 0.0, true, grey);
    plate(builder, {-lamp, -lamp}, {lamp, lamp}, 3.0, false, bright);
  }
};

// The occluder is half way up: the shadow of its edge x = b by the lamp's edge x = l is x = 2 b - l.
TEST(CriticalLines, OfASquareUnderASquareLampAreTheBordersOfUmbraAndPenumbra) {
  Stage stage(0.5);
  plate(stage.builder, {-0.75, -0.75}, {0.75, 0.75}, 1.5, true, stage.grey);
  const Traced traced(stage.builder.model());
  const std::vector<FloorLine> lines = floor_lines(traced);
  EXPECT_EQ(lines.size(), 8u);
  for (const double side : {-1.0, 1.0}) {
    for (const double at : {1.0, 2.0}) {
      const CriticalKind kind = at == 1.0 ? CriticalKind::umbra : CriticalKind::penumbra;
      EXPECT_TRUE(has_line(lines, {side * at, -2, side * at, 2, kind, 1}, traced.tolerance())) << at;
      EXPECT_TRUE(has_line(lines, {-2, side * at, 2, side * at, kind, 1}, traced.tolerance())) << at;
    }
  }
}

TEST(CriticalLines, OfAPointLikeLampAreTheOutlineOfTheShadow) {
  Stage stage(0.0005);
  plate(stage.builder, {-0.75, -0.75}, {0.75, 0.75}, 1.5, true, stage.grey);
  const Traced traced(stage.builder.model());
  const std::vector<FloorLine> lines = floor_lines(traced);
  EXPECT_EQ(lines.size(), 4u);
  for (const FloorLine& line : lines) {
    EXPECT_NEAR(std::hypot(line.x1 - line.x0, line.z1 - line.z0), 3.0, 3 * traced.tolerance());
    EXPECT_NEAR(std::max(std::abs(line.x0 + line.x1), std::abs(line.z0 + line.z1)) / 2, 1.5,
                2 * traced.tolerance());
  }
}

// The plates meet along half an edge of the larger one: a T-vertex.
TEST(CriticalLines, OfTwoPlatesThatFormAnLAreItsSixEdges) {
  Stage stage(0.0005);
  plate(stage.builder, {-1, -1}, {0, 1}, 1.5, true, stage.grey);
  plate(stage.builder, {0, -1}, {1, 0}, 1.5, true, stage.grey);
  const Traced traced(stage.builder.model());
  const std::vector<FloorLine> lines = floor_lines(traced);
  EXPECT_EQ(lines.size(), 6u);
  double length = 0;
  for (const FloorLine& line : lines) {
    length += std::hypot(line.x1 - line.x0, line.z1 - line.z0);
    EXPECT_FALSE(std::abs(line.x0) < 0.01 && std::abs(line.x1) < 0.01 && line.z0 < -0.01)
        << "the joint casts no shadow";
  }
  EXPECT_NEAR(length, 16.0, 20 * traced.tolerance());
}

// The plate's edge is not parallel to any edge of the lamp: each corner of the lamp draws a line of its own.
TEST(CriticalLines, OfEdgesThatAreNotParallelJumpInTheSecondDerivative) {
  Stage stage(0.5);
  stage.builder.polygon({{-0.8, 1.5, 0}, {0, 1.5, 0.8}, {0.8, 1.5, 0}, {0, 1.5, -0.8}}, stage.grey);
  const Traced traced(stage.builder.model());
  for (const FloorLine& line : floor_lines(traced)) {
    EXPECT_EQ(line.order, 2);
  }
  // Lamp corner (0.5, 0.5) over the edge from (0, 0.8) to (0.8, 0): the corner's shadow is 2 e - l.
  EXPECT_TRUE(
      has_line(floor_lines(traced), {-0.5, 1.1, 1.1, -0.5, CriticalKind::umbra, 2}, traced.tolerance()));
  EXPECT_TRUE(
      has_line(floor_lines(traced), {0.5, 2.1, 2.1, 0.5, CriticalKind::penumbra, 2}, traced.tolerance()));
}

TEST(CriticalLines, DoNotPassASecondOccluder) {
  Stage stage(0.5);
  plate(stage.builder, {-0.75, -0.75}, {0.75, 0.75}, 1.5, true, stage.grey);
  plate(stage.builder, {-3, -3}, {3, 3}, 0.5, true, stage.grey);
  const Traced traced(stage.builder.model());
  for (const FloorLine& line : floor_lines(traced)) {
    EXPECT_GE(std::max({std::abs(line.x0), std::abs(line.z0), std::abs(line.x1), std::abs(line.z1)}), 3.0)
        << "only the lower plate's own shadow reaches the floor";
  }
  EXPECT_FALSE(floor_lines(traced).empty());
}

TEST(CriticalLines, OfWhatStandsOnAFaceBeginAtItsContactLine) {
  for (const bool has_bottom : {false, true}) {
    Stage stage(0.5);
    stage.builder.box({1, 0, -0.5}, {2, 1, 0.5}, 0.0, stage.grey, has_bottom);
    const Traced traced(stage.builder.model());
    const std::vector<FloorLine> lines = floor_lines(traced);
    std::size_t contacts = 0;
    for (const FloorLine& line : lines) {
      contacts += line.kind == CriticalKind::contact ? 1 : 0;
      const double x = (line.x0 + line.x1) / 2, z = (line.z0 + line.z1) / 2;
      EXPECT_FALSE(x > 1.01 && x < 1.99 && std::abs(z) < 0.49) << "no light comes under the box";
    }
    EXPECT_EQ(contacts, 4u);
    EXPECT_GT(lines.size(), 8u);
  }
}

// The upper edge of the wall is in one plane with the lamp; the lamp's own corners lie on the wall.
TEST(CriticalLines, OfALampThatTouchesAWallAndIsCoplanarWithItsEdgeAreFinite) {
  ModelBuilder builder;
  const std::uint32_t grey = builder.material(glm::dvec3(0.5));
  const std::uint32_t bright = builder.material(glm::dvec3(0.5), glm::dvec3(10.0));
  builder.room(glm::dvec3(0.0), {4, 3, 4}, {grey, grey, grey, grey, grey, grey});
  plate(builder, {0, 1}, {1, 2}, 3.0, false, bright);
  const Traced empty(builder.model());
  EXPECT_TRUE(std::all_of(empty.lines.begin(), empty.lines.end(), [](const CriticalLine& l) {
    return l.kind == CriticalKind::contact;
  })) << "nothing casts a shadow";
  builder.polygon({{2, 0, 1}, {2, 3, 1}, {2, 3, 2}, {2, 0, 2}}, grey);
  const Traced screened(builder.model());
  EXPECT_FALSE(floor_lines(screened).empty());
}

// An edge of the lamp, one of the upper plate and one of the lower lie in one plane: a line, not two. The
// lower plate's other edges lie in the penumbra of the upper one, behind it as seen from the far side of the
// lamp.
TEST(CriticalLines, ThroughSeveralEdgesAreOne) {
  Stage stage(0.5);
  plate(stage.builder, {-1, -1}, {1, 1}, 1.5, true, stage.grey);
  plate(stage.builder, {-1.25, -1.25}, {1.25, 1.25}, 0.75, true, stage.grey);
  const Traced traced(stage.builder.model());
  const std::vector<FloorLine> lines = floor_lines(traced);
  EXPECT_EQ(lines.size(), 8u);
  for (const double side : {-1.5, 1.5}) {
    EXPECT_TRUE(has_line(lines, {side, -2.5, side, 2.5, CriticalKind::umbra, 1}, traced.tolerance()));
  }
}

// A grid of 5 x 5 boxes, turned by 25 angles: some 200 edges that cast shadows of 4 lamps.
TEST(CriticalLines, OfHundredsOfEdgesStayApart) {
  ModelBuilder builder;
  const std::uint32_t grey = builder.material(glm::dvec3(0.5));
  const std::uint32_t bright = builder.material(glm::dvec3(0.5), glm::dvec3(10.0));
  builder.room(glm::dvec3(0.0), {10, 3, 10}, {grey, grey, grey, grey, grey, grey});
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 low(2.0 + 5 * (i % 2), 2.0 + 5 * (i / 2));
    plate(builder, low, low + 0.4, 2.9, false, bright);
  }
  for (int i = 0; i < 25; ++i) {
    const glm::dvec3 low(0.8 + 1.8 * (i % 5), 0.0, 0.8 + 1.8 * (i / 5));
    builder.box(low, low + glm::dvec3(0.5, 0.4 + 0.03 * i, 0.6), 0.1 * i, grey, false);
  }
  const Traced traced(builder.model());
  EXPECT_GT(traced.lines.size(), 1000u);
  for (std::size_t i = 0; i < traced.lines.size(); ++i) {
    for (std::size_t j = 0; j < i && traced.lines[j].face == traced.lines[i].face; ++j) {
      const FaceFrame& frame = traced.prepared.frames[traced.lines[i].face];
      const glm::dvec3 a = frame.to_grid(traced.lines[i].a), b = frame.to_grid(traced.lines[i].b);
      const glm::dvec3 c = frame.to_grid(traced.lines[j].a), d = frame.to_grid(traced.lines[j].b);
      const double apart = std::min(std::max(glm::length(a - c), glm::length(b - d)),
                                    std::max(glm::length(a - d), glm::length(b - c)));
      EXPECT_GT(apart, 4.0);
    }
  }
}

/// Whether the segment from p to q crosses a line of its face or comes within `reach` grid units of one.
bool meets_a_line(const Traced& traced, std::uint32_t face, glm::dvec3 p, glm::dvec3 q, double reach) {
  const FaceFrame& frame = traced.prepared.frames[face];
  const glm::dvec3 middle = (p + q) / 2.0;
  const double radius = glm::length(q - p) / 2 + reach;
  return std::any_of(traced.lines.begin(), traced.lines.end(), [&](const CriticalLine& line) {
    if (line.face != face) {
      return false;
    }
    const glm::dvec3 a = frame.to_grid(line.a), d = frame.to_grid(line.b) - a;
    const double along = std::clamp(glm::dot(middle - a, d) / glm::dot(d, d), 0.0, 1.0);
    return glm::length(middle - a - along * d) <= radius;
  });
}

/// A closed room with boxes, standing or floating, under one square lamp.
Model room_with_boxes(std::uint32_t seed) {
  Random random(seed);
  ModelBuilder builder;
  const std::uint32_t grey = builder.material(glm::dvec3(0.5));
  const std::uint32_t bright = builder.material(glm::dvec3(0.5), glm::dvec3(10.0));
  builder.room(glm::dvec3(0.0), {4, 3, 4}, {grey, grey, grey, grey, grey, grey});
  const glm::dvec2 middle(random.real(1.0, 3.0), random.real(1.0, 3.0));
  plate(builder, middle - 0.3, middle + 0.3, 2.9, false, bright);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 low(random.real(0.4, 2.6), random.between(0, 1) * random.real(0.1, 0.8),
                         random.real(0.4, 2.6));
    const glm::dvec3 size(random.real(0.3, 0.9), random.real(0.2, 0.9), random.real(0.3, 0.9));
    builder.box(low, low + size, random.real(0.0, 1.5), grey);
  }
  return builder.model();
}

// The border of the lit region is made of vertex-edge events only, so nothing may be missing there.
TEST(CriticalLines, LieWhereverTheLampBeginsToBeHidden) {
  constexpr int kSteps = 400;
  int borders = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Traced traced(room_with_boxes(seed));
    const DirectLight light(traced.prepared);
    const std::uint32_t floor = 2;
    const FaceFrame& frame = traced.prepared.frames[floor];
    for (const double s : {0.13, 0.37, 0.61, 0.83}) {
      const auto at = [&](int i) { return frame.to_grid({s, (i + 0.5) / kSteps}); };
      const auto shown = [&](int i) { return light.irradiance(floor, at(i)) / light.unhidden(floor, at(i)); };
      double before = shown(0);
      for (int i = 1; i < kSteps; ++i) {
        const double share = shown(i);
        if ((share > 1 - 1e-9) != (before > 1 - 1e-9)) {
          ++borders;
          EXPECT_TRUE(meets_a_line(traced, floor, at(i - 1), at(i), 6.0))
              << "seed " << seed << " s " << s << " step " << i << " " << before << " -> " << share;
        }
        before = share;
      }
    }
  }
  EXPECT_GT(borders, 100);
}

void expect_sound(const Traced& traced, std::uint32_t seed) {
  for (const CriticalLine& line : traced.lines) {
    const FaceFrame& frame = traced.prepared.frames[line.face];
    for (const glm::dvec2 end : {line.a, line.b}) {
      ASSERT_TRUE(std::isfinite(end.x) && std::isfinite(end.y)) << "seed " << seed;
      const glm::dvec3 p = frame.to_grid(end);
      for (std::size_t k = 0; k < frame.outline.size(); ++k) {
        const glm::dvec3 a = frame.to_grid(frame.outline[k]);
        const glm::dvec3 side = frame.to_grid(frame.outline[(k + 1) % frame.outline.size()]) - a;
        EXPECT_GT(glm::dot(glm::cross(frame.normal, side), p - a) / glm::length(side), -4.0)
            << "seed " << seed;
      }
    }
    EXPECT_GE(line.length, 4.0);
    EXPECT_TRUE(std::isfinite(line.irradiance) && line.irradiance >= 0) << "seed " << seed;
    EXPECT_TRUE(std::isfinite(line.width) && line.width >= 1) << "seed " << seed;
  }
}

TEST(CriticalLines, OfRandomRoomsAreFiniteAndOnTheirFaces) {
  const std::uint32_t seeds = seed_count(150);
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    expect_sound(Traced(random_closed_room(seed)), seed);
    expect_sound(Traced(random_open_room(seed)), seed);
  }
}

TEST(CriticalLines, AreTheSameEachTime) {
  const Model model = random_open_room(7);
  const Traced first(model), second(model);
  ASSERT_EQ(first.lines.size(), second.lines.size());
  for (std::size_t i = 0; i < first.lines.size(); ++i) {
    EXPECT_EQ(first.lines[i].a, second.lines[i].a);
    EXPECT_EQ(first.lines[i].b, second.lines[i].b);
  }
}

}  // namespace
}  // namespace fixrad::host

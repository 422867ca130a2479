// SPDX-License-Identifier: MIT
// Rays between elements: where they begin and end, what blocks them, and the rows made of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lib/form_factor/area_points.h"
#include "lib/form_factor/ray_blockers.h"
#include "lib/form_factor/row_balance.h"
#include "tests/lib/closed_forms.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

Polygon polygon_of(const std::vector<Vec3>& corners) {
  Polygon polygon = {};
  for (const Vec3& p : corners) {
    polygon.corner[polygon.count++] = p;
  }
  return polygon;
}

SolveOptions ray_options(std::uint32_t elements, const DeltaTable& rays) {
  SolveOptions options;
  options.elements = elements;
  options.settings.engine = ray_row;
  options.settings.tables = &rays;
  options.settings.table_count = 1;
  return options;
}

std::uint64_t row_total(const State& state) {
  std::uint64_t sum = state.row.escaped + state.row.back;
  for (unsigned j = 0; j < state.scene.element_count; ++j) {
    sum += state.row.share[j];
  }
  return sum;
}

void sample_eye(State& state, std::uint32_t element, std::uint32_t weight, bool back_faces) {
  const EyeSample sample = {element_eye(state.scene, element), weight, back_faces};
  ASSERT_EQ(ray_row(state.scene, *state.settings.tables, sample, state.work, state.row), Status::ok);
}

TEST(RayCoordinates, AreStratifiedInEveryCoordinateAndInBeginAndEnd) {
  for (int log2 = 2; log2 <= kMaxRaysLog2; ++log2) {
    const int n = 1 << log2;
    for (const std::uint32_t pair : {0u, 17u, 0x12345u}) {
      std::set<int> from_s, from_t, to_s, to_t, from;
      const int rows = log2 / 2, columns = log2 - rows;
      for (int i = 0; i < n; ++i) {
        const RayCoordinates c = ray_coordinates(i, log2, pair);
        from_s.insert(c.from_s >> (16 - log2));
        from_t.insert(c.from_t >> (16 - log2));
        to_s.insert(c.to_s >> (16 - log2));
        to_t.insert(c.to_t >> (16 - log2));
        from.insert((c.from_s >> (16 - columns)) << rows | c.from_t >> (16 - rows));
      }
      for (const auto& strata : {from_s, from_t, to_s, to_t, from}) {
        EXPECT_EQ(strata.size(), static_cast<std::size_t>(n)) << "one ray a stratum";
      }
    }
  }
}

TEST(AreaPoints, OfAnElementThatCutsHaveLeftNothingOfLieOnTheGrid) {
  Polygon polygon = {};
  for (polygon.count = 0; polygon.count < 3; ++polygon.count) {
    const Vec3 point = AreaPoints(polygon).at(0x8000, 0xffff);
    EXPECT_EQ(max_magnitude(point), 0u) << polygon.count << " corners, all at the origin";
  }
}

TEST(AreaPoints, FallOnEveryHalfOfAPolygonByItsArea) {
  const std::vector<Polygon> polygons = {
      polygon_of({{0, 0, 0}, {6400, 0, 0}, {6400, 6400, 0}, {0, 6400, 0}}),
      polygon_of({{0, 0, 0}, {6400, 0, 0}, {6400, 6400, 0}}),
      polygon_of({{0, 0, 0}, {6400, 0, 0}, {4800, 6400, 0}, {1600, 6400, 0}}),
      polygon_of(
          {{2000, 0, 0}, {4400, 0, 0}, {6400, 3200, 0}, {4400, 6400, 0}, {2000, 6400, 0}, {0, 3200, 0}})};
  const double centroid_x[] = {3200, 12800 / 3.0, 3200, 3200};
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const AreaPoints points(polygons[k]);
    double sum = 0;
    constexpr int kSide = 64;
    for (int i = 0; i < kSide * kSide; ++i) {
      const Vec3 p = points.at(static_cast<std::uint16_t>((2 * (i % kSide) + 1) * 512),
                               static_cast<std::uint16_t>((2 * (i / kSide) + 1) * 512));
      ASSERT_TRUE(p.x >= 0 && p.x <= 6400 && p.y >= 0 && p.y <= 6400 && p.z == 0);
      sum += p.x;
    }
    EXPECT_NEAR(sum / (kSide * kSide), centroid_x[k], 0.01 * 6400) << "polygon " << k;
  }
}

// A plate of half the size midway between two plates: rays through its edges and corners meet it as well.
TEST(RayBlockers, BlockExactlyTheRaysThatPassThroughTheFace) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, 0);
  builder.polygon({{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}, 0);
  builder.polygon({{0.25, 0.5, 0.25}, {0.75, 0.5, 0.25}, {0.75, 0.5, 0.75}, {0.25, 0.5, 0.75}}, 0);
  Solution solution(builder.model(), ray_options(3, kLunes[2]));
  State& state = solution.state();
  Polygon floor, ceiling, plate;
  face_outline(state.scene, flash_read(state.scene.faces, 0), floor);
  face_outline(state.scene, flash_read(state.scene.faces, 1), ceiling);
  face_outline(state.scene, flash_read(state.scene.faces, 2), plate);
  RayBlockers blockers(state.scene, state.work);
  blockers.enter_source(0, floor);
  blockers.enter_target(2);
  EXPECT_TRUE(blockers.is_free()) << "nothing stands before the plate";
  blockers.enter_target(1);
  ASSERT_FALSE(blockers.is_free());
  const auto through = [&](const Vec3& p) {
    const Vec3 from = {floor.corner[0].x + 100, floor.corner[0].y, floor.corner[0].z + 50};
    return blockers.is_blocked(from, {2 * p.x - from.x, 2 * p.y - from.y, 2 * p.z - from.z});
  };
  for (int k = 0; k < 4; ++k) {
    const Vec3 c = plate.corner[k], middle = {(plate.corner[0].x + plate.corner[2].x) / 2, c.y,
                                              (plate.corner[0].z + plate.corner[2].z) / 2};
    const int dx = c.x < middle.x ? -1 : 1, dz = c.z < middle.z ? -1 : 1;
    EXPECT_TRUE(through(c)) << "corner " << k;
    EXPECT_TRUE(through({c.x, c.y, middle.z})) << "edge " << k;
    EXPECT_TRUE(through({c.x - dx, c.y, c.z - dz})) << "inside, corner " << k;
    EXPECT_FALSE(through({c.x + dx, c.y, c.z})) << "outside, corner " << k;
    EXPECT_FALSE(through({c.x, c.y, c.z + dz})) << "outside, corner " << k;
  }
}

TEST(RowBalance, ScalesToTheSumExactlyAndKeepsWhatIsFixed) {
  std::uint32_t share[] = {100, kFixedShare | 5000, 0, 70000, 1, kFixedShare | 30};
  FormFactorRow row = {share, 6, 400, 9};
  balance_row(row, kRowOne);
  EXPECT_EQ(share[1], 5000u);
  EXPECT_EQ(share[5], 30u);
  EXPECT_EQ(share[2], 0u);
  const double ratio = (kRowOne - 5030.0) / (100 + 70000 + 1 + 409);
  EXPECT_NEAR(share[0], 100 * ratio, 1);
  EXPECT_NEAR(share[3], 70000 * ratio, 1);
  EXPECT_NEAR(row.escaped, 400 * ratio, 1);
  EXPECT_EQ(share[0] + share[1] + share[2] + share[3] + share[4] + share[5] + row.escaped + row.back,
            kRowOne);
}

TEST(RowBalance, ScalesFixedEntriesThatAloneAreTooMuch) {
  std::uint32_t share[] = {kFixedShare | 900000, 7, kFixedShare | 300000};
  FormFactorRow row = {share, 3, 5, 0};
  balance_row(row, kRowOne);
  EXPECT_EQ(share[0] + share[1] + share[2] + row.escaped + row.back, kRowOne);
  EXPECT_EQ(share[1], 0u);
  EXPECT_NEAR(share[0], 0.75 * kRowOne, 1);
}

TEST(RowBalance, LetsEscapeWhatNothingIsThereToTake) {
  std::uint32_t share[] = {0, 0};
  FormFactorRow row = {share, 2, 0, 0};
  balance_row(row, 12345);
  EXPECT_EQ(row.escaped, 12345u);
}

TEST(RayRow, IsARowOfOneFromEveryEye) {
  for (const auto& [model, is_closed] :
       {std::pair{cornell(), false}, {random_open_room(4), false}, {random_closed_room(5), true}}) {
    Solution solution(model, ray_options(150, kLunes[1]));
    State& state = solution.state();
    for (unsigned e = 0; e < state.scene.element_count; e += 3) {
      clear(state.row);
      sample_eye(state, e, kRowOne / 5, !is_closed);
      sample_eye(state, e, kRowOne - kRowOne / 5, !is_closed);
      ASSERT_EQ(row_total(state), kRowOne) << "element " << e;
    }
  }
}

TEST(RayRow, LosesNothingInAClosedRoomWithBodies) {
  Solution solution(random_closed_room(5), ray_options(120, kLunes[0]));
  ASSERT_EQ(solution.run(), Status::converged);
  for (int c = 0; c < solution.state().scene.channels; ++c) {
    EXPECT_EQ(solution.state().escaped[c], 0);
  }
  EXPECT_EQ(solution.imbalance(), 0);
}

// A plate between two plates, half as large and half way: seen from the middle of the floor it hides the
// middle of the ceiling, all of the square of the same half size scaled by two.
TEST(RayRow, SeesAroundAPlateInTheWay) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.polygon({{0.49, 0, 0.49}, {0.49, 0, 0.51}, {0.51, 0, 0.51}, {0.51, 0, 0.49}}, 0);
  builder.polygon({{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}, 0);
  builder.polygon({{0.375, 0.5, 0.375}, {0.625, 0.5, 0.375}, {0.625, 0.5, 0.625}, {0.375, 0.5, 0.625}}, 0);
  Solution solution(builder.model(), ray_options(300, kLunes[3]));
  State& state = solution.state();
  clear(state.row);
  sample_eye(state, 0, kRowOne, true);
  double to_ceiling = 0;
  for (unsigned j = 0; j < state.scene.element_count; ++j) {
    to_ceiling += flash_read(state.scene.elements, j).face == 1 ? state.row.share[j] / double{kRowOne} : 0;
  }
  const double whole = point_to_parallel({-0.5, 0.5, -0.5, 0.5}, 1.0);
  const double hidden = point_to_parallel({-0.25, 0.25, -0.25, 0.25}, 1.0);
  EXPECT_NEAR(to_ceiling, whole - hidden, 0.03 * whole);
  EXPECT_NEAR(state.row.back / double{kRowOne}, 0, 0.001) << "the plate turns its back to the ceiling only";
}

// Mean over the floor's elements of what reaches the wall that stands on it: touching elements included.
TEST(RayRow, ToATouchingWallIsTheClosedForm) {
  constexpr double kBound = 0.005;  // four points an element
  Solution solution(perpendicular_squares(0, 1, 0), ray_options(50, kLunes[0]));
  State& state = solution.state();
  double mean = 0;
  int count = 0;
  for (unsigned e = 0; e < state.scene.element_count; ++e) {
    if (flash_read(state.scene.elements, e).face != 0) {
      continue;
    }
    clear(state.row);
    sample_eye(state, e, kRowOne, true);
    for (unsigned j = 0; j < state.scene.element_count; ++j) {
      mean += flash_read(state.scene.elements, j).face == 1 ? state.row.share[j] / double{kRowOne} : 0;
    }
    ++count;
  }
  EXPECT_NEAR(mean / count / kPerpendicularUnitSquares, 1.0, kBound);
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// The measures behind the twin's rows, and its form factors where closed forms are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "host_sim/reference/twin_hemisphere.h"
#include "host_sim/tables/delta_form_factors.h"
#include "tests/reference/twin_room.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Form factor of the part of lune `r` of R between the plane of its middle and `angle` from there, by the
// definition: the integral of cos(theta) / pi over directions at latitude `latitude` and longitude
// `longitude` about the axis, longitudes measured from the normal. Midpoint rule.
double lune_by_quadrature(int resolution, int r, double angle) {
  constexpr int kSteps = 400;
  const double from = std::asin(2.0 * r / resolution - 1), to = std::asin(2.0 * (r + 1) / resolution - 1);
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double longitude = from + (i + 0.5) / kSteps * (to - from);
    for (int k = 0; k < kSteps; ++k) {
      const double latitude = (k + 0.5) / kSteps * angle;
      const double cos_theta = std::cos(latitude) * std::cos(longitude);
      const double solid_angle = std::cos(latitude);
      sum += cos_theta * solid_angle;
    }
  }
  return sum * (angle / kSteps) * ((to - from) / kSteps) / kPi;
}

constexpr double kQuadratureError = 1e-5;

TEST(Lunes, AllOfAHemisphereWeighTheSame) {
  for (const int resolution : {4, 8, 16}) {
    for (int r = 0; r < resolution; ++r) {
      EXPECT_NEAR(2 * lune_by_quadrature(resolution, r, kPi / 2) * resolution, 1.0, kQuadratureError);
    }
  }
}

TEST(Lunes, RunningSumsAreTheCosineIntegratedOverTheLune) {
  for (const double u : {0.1, 0.3, 0.5, 0.7, 0.95}) {
    const double angle = std::atan(u / (1 - u));
    for (const int r : {0, 3, 7}) {
      const double part = 8 * lune_by_quadrature(8, r, angle);
      EXPECT_NEAR(half_lune_integral(u), part, kQuadratureError);
      const TwinDeltaRow row = twin_lune_delta_row(8);
      EXPECT_NEAR(8 * (row.sum_to(u) - row.sum_to(-u)), 2 * part, 2 * kQuadratureError);
    }
  }
}

class LuneTables : public ::testing::TestWithParam<const DeltaTable*> {};

TEST_P(LuneTables, HalfRowsSumToExactlyHalfALune) {
  const DeltaTable& table = *GetParam();
  EXPECT_EQ(flash_read(table.top, kLuneParts - 1), 1u << 15);
  std::uint32_t all = 0;
  for (int r = 0; r < 1 << table.resolution_log2; ++r) {
    const DeltaRow row = delta_row(table, true, r);
    EXPECT_EQ(row.sum_to(0), 0u);
    EXPECT_EQ(row.sum_to(kRowMiddle) * 2, row.sum_to(kRowEnd));
    all += row.sum_to(kRowEnd);
  }
  EXPECT_EQ(all, 1u << kDeltaSumLog2);
}

TEST_P(LuneTables, AreWhatTheirProgramComputes) {
  const DeltaTable& table = *GetParam();
  const std::vector<std::uint16_t> half_row = make_lune_half_row();
  for (unsigned i = 0; i < kLuneParts; ++i) {
    ASSERT_EQ(flash_read(table.top, i), half_row[i]);
  }
  const std::vector<std::int16_t> cosines = make_lune_cosines(1 << table.resolution_log2);
  for (unsigned i = 0; i < cosines.size(); ++i) {
    ASSERT_EQ(flash_read(table.cosine, i), cosines[i]);
  }
}

// In units of 2^-16 of a row: 1/2 by rounding an entry, 1/3 by the curvature between entries (the second
// derivative is at most 2.66, and 2.66 / 8 / 256^2 = 0.34 / 2^16); and one unit of the sum by its cut.
TEST_P(LuneTables, RunningSumsAreExactToAUnitOfTheTable) {
  const DeltaTable& table = *GetParam();
  const DeltaRow row = delta_row(table, true, 0);
  const double lune = std::ldexp(1.0, kDeltaSumLog2 - table.resolution_log2);
  for (std::int32_t x = kRowMiddle; x <= kRowEnd; x += 7) {
    const double u = static_cast<double>(x - kRowMiddle) / kRowMiddle;
    ASSERT_NEAR(row.sum_to(x), lune * (0.5 + half_lune_integral(u)), 1 + lune * std::ldexp(1.0, -16));
  }
}

TEST_P(LuneTables, RowsAreUnitVectorsEquallySpacedInTheirSine) {
  const DeltaTable& table = *GetParam();
  const int size = 1 << table.resolution_log2;
  for (int r = 0; r < size; ++r) {
    const RowPlane plane = row_plane(table, r);
    EXPECT_EQ(std::ldexp(plane.y, -kPlaneBits), static_cast<double>(2 * r + 1 - size) / size);
    EXPECT_NEAR(std::hypot(plane.y, plane.z), 1 << kPlaneBits, 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(R, LuneTables,
                         ::testing::Values(kLunes, kLunes + 1, kLunes + 2, kLunes + 3, kLunes + 4,
                                           kLunes + 5),
                         [](const auto& table) { return std::to_string(1 << table.param->resolution_log2); });

TEST(TwinDeltaTable, SumsToOneOverTheHemicube) {
  for (const int resolution : {8, 16, 32, 64, 128}) {
    const TwinDeltaTable table(resolution);
    double sum = 0;
    for (int r = 0; r < resolution; ++r) {
      sum +=
          table.row(true, r).sum_to(1.0) + (r >= resolution / 2 ? 4 * table.row(false, r).sum_to(1.0) : 0.0);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

// Form factors between unit squares: parallel at a distance of 1, and perpendicular with a common edge.
constexpr double kParallel = 0.19982489569838746;
constexpr double kPerpendicular = 0.20004377607540316;
constexpr int kSide = 8000;

class TwinFormFactorsOf : public ::testing::TestWithParam<TwinEngine> {
 protected:
  TwinFormFactorsOf() {
    const std::uint16_t paint = room_.add_material({0.5, 0.5, 0.5}, {1, 1, 1});
    const Vec3 x = {kSide, 0, 0}, y = {0, kSide, 0}, z = {0, 0, kSide};
    room_.add_quad({0, 0, 0}, x, y, 2, paint);
    room_.add_quad(z, y, x, 5, paint);
    room_.add_quad({0, 0, 0}, y, z, 5, paint);
  }

  // From n x n eyes of the first square to another face, and all there is of them.
  struct Mean {
    double share, total;
  };
  Mean mean_to_face(std::uint16_t face, int n, int resolution) {
    const Scene scene = room_.scene();
    const TwinScene twin = make_twin_scene(scene);
    TwinHemisphere hemisphere(twin, GetParam());
    TwinFormFactors row;
    row.share.resize(twin.element_count());
    const int step = kSide * kEyeScale / n;
    for (int i = 0; i < n * n; ++i) {
      const Vec3 at = {i % n * step + step / 2, i / n * step + step / 2, 2};
      const EyePoint eye = {at, 0, static_cast<std::uint8_t>(i % kTurns)};
      hemisphere.add({{eye, kRowOne, true}, resolution}, row);
    }
    double share = 0;
    for (std::uint16_t e = 0; e < scene.element_count; ++e) {
      share += flash_read(scene.elements, e).face == face ? row.share[e] : 0.0;
    }
    const double total = std::accumulate(row.share.begin(), row.share.end(), row.escaped + row.back);
    return {share / (n * n), total / (n * n)};
  }

  TwinRoom room_;
};

TEST_P(TwinFormFactorsOf, ConvergeToTheClosedFormOfParallelSquares) {
  const double coarse = std::fabs(mean_to_face(1, 4, 8).share / kParallel - 1);
  const double fine = std::fabs(mean_to_face(1, 40, 64).share / kParallel - 1);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, 0.0003);
  EXPECT_LT(fine, coarse);
}

TEST_P(TwinFormFactorsOf, ConvergeToTheClosedFormOfPerpendicularSquares) {
  const double coarse = std::fabs(mean_to_face(2, 4, 8).share / kPerpendicular - 1);
  const double fine = std::fabs(mean_to_face(2, 40, 64).share / kPerpendicular - 1);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, 0.0003);
  EXPECT_LT(fine, coarse);
}

TEST_P(TwinFormFactorsOf, SumToTheWeightOfTheEyes) {
  EXPECT_NEAR(mean_to_face(1, 4, 8).total, 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Engine, TwinFormFactorsOf, ::testing::Values(TwinEngine::rows, TwinEngine::lunes),
                         [](const auto& engine) {
                           return engine.param == TwinEngine::rows ? "HemicubeRows" : "Lunes";
                         });

}  // namespace
}  // namespace fixrad::host

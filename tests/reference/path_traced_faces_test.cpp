// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "host_sim/reference/contour.h"
#include "host_sim/reference/path_tracer.h"
#include "tests/reference/grid_mesh.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.141592653589793;

const glm::dvec3 kX{1, 0, 0};
const glm::dvec3 kY{0, 1, 0};
const glm::dvec3 kZ{0, 0, 1};
const Paint kBlack{};
const Paint kLamp{glm::dvec3{0.0}, glm::dvec3{1.0}};
const Paint kGrey{glm::dvec3{0.5}, glm::dvec3{0.0}};

FaceTracingOptions some_paths(std::uint64_t paths) {
  FaceTracingOptions options;
  options.paths = paths;
  return options;
}

/// Two equal parallel squares of side 1, `gap` apart: the closed form of every textbook.
double parallel_squares(double gap) {
  const double x = 1.0 / gap;
  const double s = 1.0 + x * x;
  return 2.0 / (kPi * x * x) *
         (0.5 * std::log(s * s / (1.0 + 2.0 * x * x)) + 2.0 * x * std::sqrt(s) * std::atan(x / std::sqrt(s)) -
          2.0 * x * std::atan(x));
}

/// The far corner makes the lamp the smaller part of the scene, so that it is looked for.
void add_far_square(ElementMesh& mesh) {
  add_grid(mesh, {50, 50, 50}, 3.0 * kX, 3.0 * kY, 1, 1, kBlack);
}

TEST(PathTracedFaces, ParallelSquaresFromFarToTouchingGetTheirFormFactor) {
  for (const double gap : {4.0, 1.0, 0.1, 0.01}) {
    ElementMesh mesh;
    add_grid(mesh, {0, 0, 0}, kX, kY, 1, 1, kGrey);
    add_grid(mesh, gap * kZ, kY, kX, 1, 1, kLamp);
    add_far_square(mesh);
    const Traced traced = path_traced_faces(mesh.elements, some_paths(1U << 16U));
    const double expected = 0.5 * parallel_squares(gap);
    EXPECT_LT(traced.standard_error[0].x, 2e-3 * expected) << gap;
    EXPECT_NEAR(traced.mean[0].x, expected, 3.5 * traced.standard_error[0].x + 1e-6) << gap;
  }
}

TEST(PathTracedFaces, SeveralPolygonsOfOneFaceAreOneSurface) {
  ElementMesh pieces;
  add_grid(pieces, {0, 0, 0}, kX, kY, 3, 2, kGrey);
  add_grid(pieces, kZ, kY, kX, 2, 1, kLamp);
  add_far_square(pieces);
  const Traced traced = path_traced_faces(pieces.elements, some_paths(1U << 16U));
  ASSERT_EQ(traced.mean.size(), 3U);
  EXPECT_LT(traced.standard_error[0].x, 2e-4);
  EXPECT_NEAR(traced.mean[0].x, 0.5 * parallel_squares(1.0), 3.5 * traced.standard_error[0].x);
  EXPECT_EQ(traced.mean[1], glm::dvec3{1.0});
}

TEST(PathTracedFaces, AFaceWithoutPolygonsIsZero) {
  ElementMesh mesh = unit_cube(1, kGrey, kLamp);
  for (MeshElement& element : mesh.elements) {
    element.input_face += 2;
  }
  const Traced traced = path_traced_faces(mesh.elements, some_paths(1024));
  ASSERT_EQ(traced.mean.size(), 8U);
  EXPECT_EQ(traced.mean[0], glm::dvec3{0.0});
  EXPECT_GT(traced.mean[2].x, 0.0);
}

TEST(PathTracedFaces, AFurnaceIsDarkOnlyUnderABlockThatStandsOnItsFloor) {
  // A closed block touches the floor with its bottom. Outside the radiosity is E / (1 - rho) everywhere; what
  // is covered sees no light, so bottom and covered floor emit only.
  const double rho = 0.5;
  const Paint paint{glm::dvec3{rho}, glm::dvec3{1.0}};
  ElementMesh mesh = unit_cube(1, paint, paint);
  const glm::dvec3 corner{0.2, 0.3, 0.0};
  const glm::dvec3 u{0.4, 0.0, 0.0};
  const glm::dvec3 v{0.0, 0.5, 0.0};
  const glm::dvec3 w{0.0, 0.0, 0.6};
  add_grid(mesh, corner, v, u, 1, 1, paint);  // bottom, looks down
  add_grid(mesh, corner + w, u, v, 1, 1, paint);
  add_grid(mesh, corner, u, w, 1, 1, paint);
  add_grid(mesh, corner + v, w, u, 1, 1, paint);
  add_grid(mesh, corner, w, v, 1, 1, paint);
  add_grid(mesh, corner + u, v, w, 1, 1, paint);
  const Traced traced = path_traced_faces(mesh.elements, some_paths(1U << 17U));
  const double lit = 1.0 / (1.0 - rho);
  const double covered = 0.4 * 0.5;
  for (std::size_t face = 0; face < 12; ++face) {
    const double expected = face == 0 ? covered * 1.0 + (1.0 - covered) * lit : face == 6 ? 1.0 : lit;
    EXPECT_LT(traced.standard_error[face].x, 1e-2) << face;
    EXPECT_NEAR(traced.mean[face].x, expected, 4.0 * traced.standard_error[face].x + 1e-4) << face;
  }
}

TEST(PathTracedFaces, PathsGoWhereTheNoiseCounts) {
  // One square sees the lamp, the other nothing: all paths but the first round's are spent on the first.
  ElementMesh mesh;
  add_grid(mesh, {0, 0, 0}, kX, kY, 1, 1, kGrey);
  add_grid(mesh, {20, 0, 0}, kY, kX, 1, 1, kGrey);  // looks away
  add_grid(mesh, kZ, kY, kX, 1, 1, kLamp);
  add_far_square(mesh);
  const double few = path_traced_faces(mesh.elements, some_paths(1U << 13U)).standard_error[0].x;
  const double many = path_traced_faces(mesh.elements, some_paths(1U << 17U)).standard_error[0].x;
  EXPECT_LT(many, 0.3 * few);  // at least as 1 / sqrt(16), with room for the noise of an estimated noise
}

TEST(PathTracedFaces, DoNotDependOnTheNumberOfThreads) {
  const ElementMesh mesh = unit_cube(1, kLamp, kGrey);
  const Traced parallel = path_traced_faces(mesh.elements, some_paths(1U << 14U));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Traced serial = path_traced_faces(mesh.elements, some_paths(1U << 14U));
  EXPECT_EQ(serial.mean, parallel.mean);
  EXPECT_EQ(serial.standard_error, parallel.standard_error);
}

TEST(PathTracedFaces, StandardErrorsOfDifferentSeedsCoverTheTruth) {
  ElementMesh mesh;
  add_grid(mesh, {0, 0, 0}, kX, kY, 1, 1, kGrey);
  add_grid(mesh, kZ, kY, kX, 1, 1, kLamp);
  add_far_square(mesh);
  const double expected = 0.5 * parallel_squares(1.0);
  int within = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    FaceTracingOptions options = some_paths(1U << 12U);
    options.seed = seed;
    const Traced traced = path_traced_faces(mesh.elements, options);
    within += std::abs(traced.mean[0].x - expected) <= traced.standard_error[0].x ? 1 : 0;
  }
  // 67 of 100 are expected of Student's distribution with 15 degrees of freedom, give or take 5.
  EXPECT_GE(within, 50);
  EXPECT_LE(within, 84);
}

TEST(PathTracedIrradiance, APointBelowAPolygonGetsItsClosedFormFactor) {
  ElementMesh mesh;
  add_grid(mesh, {-0.3, 0.2, 0.5}, kY, 2.0 * kX, 1, 1, kLamp);
  add_far_square(mesh);
  const glm::dvec3 tilted = glm::normalize(glm::dvec3{0.3, -0.2, 1.0});
  const std::vector<SurfacePoint> points{{{0, 0, 0}, kZ}, {{0.4, 0.4, 0.2}, kZ}, {{-2, 1, 0.1}, tilted}};
  PointTracingOptions options;
  options.paths_per_point = 65536;
  const Traced traced = path_traced_irradiance(mesh.elements, points, options);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double expected = point_to_polygon(points[k].position, points[k].normal, mesh.elements[0].polygon);
    EXPECT_LT(traced.standard_error[k].x, 3e-3 * expected) << k;
    EXPECT_NEAR(traced.mean[k].x, expected, 3.5 * traced.standard_error[k].x + 1e-6) << k;
  }
}

TEST(PathTracedIrradiance, APointUnderADiscGetsTheTextbookAnswer) {
  // r^2 / (r^2 + h^2) on the axis of a disc. Its 96 triangles have 1 - (2 pi / 96)^2 / 6 of its area.
  const double radius = 0.7;
  const double height = 1.1;
  constexpr int kSides = 96;
  std::vector<MeshElement> disc;
  for (int k = 0; k < kSides; ++k) {
    const auto rim = [&](int corner) {
      const double angle = 2.0 * kPi * corner / kSides;
      return glm::dvec3{radius * std::cos(angle), radius * std::sin(angle), height};
    };
    MeshElement part;
    part.polygon = {height * kZ, rim(k + 1), rim(k)};
    part.normal = -kZ;
    part.centroid = (part.polygon[0] + part.polygon[1] + part.polygon[2]) / 3.0;
    part.area = 0.5 * radius * radius * std::sin(2.0 * kPi / kSides);
    part.emission = glm::dvec3{1.0};
    disc.push_back(part);
  }
  const Traced traced = path_traced_irradiance(disc, {{{0, 0, 0}, kZ}});
  const double expected = radius * radius / (radius * radius + height * height);
  EXPECT_LT(traced.standard_error[0].x, 3e-3 * expected);
  EXPECT_NEAR(traced.mean[0].x, expected, 3.5 * traced.standard_error[0].x + 1e-3 * expected);
}

TEST(PathTracedIrradiance, EveryPointOfAFurnaceGetsTheSameEvenInItsCorners) {
  const Paint paint{glm::dvec3{0.5}, glm::dvec3{1.0}};
  const std::vector<SurfacePoint> points{
      {{0.5, 0.5, 0.0}, kZ}, {{0.0, 0.0, 0.0}, kZ}, {{1.0, 1.0, 0.0}, kZ}, {{0.0, 1e-6, 1e-6}, kX}};
  const Traced traced = path_traced_irradiance(unit_cube(1, paint, paint).elements, points);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_LT(traced.standard_error[k].x, 0.02) << k;
    EXPECT_NEAR(traced.mean[k].x, 2.0, 3.5 * traced.standard_error[k].x) << k;
  }
}

TEST(PathTracedIrradiance, APointOnTheEdgeOfABlockIsOnItsLitSide) {
  // The rim of a table top, and the foot of a wall that stands on a floor: half of either is in the dark.
  ElementMesh mesh;
  add_grid(mesh, {0, 0, 0}, kX, kY, 1, 1, kGrey);
  add_grid(mesh, {1, 0, -1}, kY, kZ, 1, 1, kGrey);  // side of the block, looks outwards
  add_grid(mesh, {0, 0, 0}, kY, kZ, 1, 1, kGrey);   // wall at x = 0, looks to the lamp
  add_grid(mesh, 2.0 * kZ, kY, kX, 1, 1, kLamp);
  add_far_square(mesh);
  const std::vector<SurfacePoint> points{{{1, 0.4, 0}, kZ}, {{0, 0.4, 0}, kZ}};
  const Traced traced = path_traced_irradiance(mesh.elements, points);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double direct = point_to_polygon(points[k].position, kZ, mesh.elements[3].polygon);
    EXPECT_GT(traced.mean[k].x, direct - 4.0 * traced.standard_error[k].x) << k;
  }
}

TEST(PathTracedIrradiance, AClosedFurnaceLeaksNothingEvenAtReflectance999) {
  // Every leak is repeated a thousand times: one ray in ten thousand would take a tenth of the light.
  const Paint paint{glm::dvec3{0.999}, glm::dvec3{1.0}};
  const Traced traced = path_traced_irradiance(unit_cube(1, paint, paint).elements, {{{0.3, 0.6, 0.0}, kZ}});
  EXPECT_LT(traced.standard_error[0].x, 25.0);
  EXPECT_NEAR(traced.mean[0].x, 1000.0, 3.5 * traced.standard_error[0].x);
}

TEST(PathTracing, RefusesASingleBatch) {
  const ElementMesh mesh = unit_cube(1, kGrey, kLamp);
  FaceTracingOptions faces;
  faces.batches = 1;
  EXPECT_THROW(path_traced_faces(mesh.elements, faces), std::invalid_argument);
  PointTracingOptions points;
  points.batches = 1;
  EXPECT_THROW(path_traced_irradiance(mesh.elements, {{{0.5, 0.5, 0.0}, kZ}}, points), std::invalid_argument);
}

}  // namespace
}  // namespace fixrad::host

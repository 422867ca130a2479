// SPDX-License-Identifier: MIT
#include "host_sim/reference/path_tracer.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host_sim/reference/radiosity.h"
#include "tests/reference/grid_mesh.h"

namespace fixrad::host {
namespace {

const glm::dvec3 kX{1, 0, 0};
const glm::dvec3 kY{0, 1, 0};
const glm::dvec3 kZ{0, 0, 1};

TEST(PathTracer, FurnaceIsExactWithinItsStandardError) {
  for (const double rho : {0.1, 0.5, 0.9, 0.99}) {
    const Paint paint{glm::dvec3{rho}, glm::dvec3{1.0}};
    const ElementMesh mesh = unit_cube(1, paint, paint);
    PathTracingOptions options;
    options.paths_per_element = 8192;
    const PathTracedRadiosity traced = path_traced_radiosity(mesh, options);
    const double expected = 1.0 / (1.0 - rho);
    double mean = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      mean += traced.mean[i].x / 6.0;
      variance += traced.standard_error[i].x * traced.standard_error[i].x / 36.0;
    }
    EXPECT_LT(std::sqrt(variance), 0.005 * expected) << rho;
    EXPECT_NEAR(mean, expected, 3.0 * std::sqrt(variance)) << rho;
  }
}

TEST(PathTracer, DirectLightBetweenParallelSquaresIsTheirFormFactor) {
  ElementMesh mesh;
  add_grid(mesh, {0, 0, 0}, kX, kY, 1, 1, {glm::dvec3{0.5}, glm::dvec3{0.0}});
  add_grid(mesh, kZ, kY, kX, 2, 2, {glm::dvec3{0.0}, {1.0, 10.0, 0.0}});
  add_grid(mesh, {5, 5, 5}, kX, kY, 1, 1, {});  // out of sight; makes the lamp the smaller part of the scene
  const PathTracedRadiosity traced = path_traced_radiosity(mesh);
  const double expected = 0.5 * 0.19982489569838746;
  EXPECT_LT(traced.standard_error[0].x, 0.01 * expected);
  EXPECT_NEAR(traced.mean[0].x, expected, 3.0 * traced.standard_error[0].x);
  EXPECT_NEAR(traced.mean[0].y, 10.0 * expected, 30.0 * traced.standard_error[0].x);
  EXPECT_EQ(traced.mean[0].z, 0.0);
  EXPECT_EQ(traced.mean[1], (glm::dvec3{1.0, 10.0, 0.0}));
}

TEST(PathTracer, ALampThatTouchesTheWallStaysWithinItsStandardError) {
  ElementMesh mesh;
  add_grid(mesh, {0, 0, 0}, kX, kY, 2, 2, {glm::dvec3{0.5}, glm::dvec3{0.0}});
  add_grid(mesh, {0, 0, 0}, kY, kZ, 1, 1, {glm::dvec3{0.0}, glm::dvec3{1.0}});
  add_grid(mesh, {5, 5, 5}, kX, kY, 1, 1, {});
  const PathTracedRadiosity traced = path_traced_radiosity(mesh);
  const glm::dvec3 mean = face_means(mesh, traced.mean)[0];
  const glm::dvec3 error = face_standard_errors(mesh, traced.standard_error)[0];
  EXPECT_LT(error.x, 0.01 * mean.x);
  EXPECT_NEAR(mean.x, 0.5 * 0.20004377607540316, 3.0 * error.x);
}

TEST(PathTracer, BackFacesAreBlackAndBlock) {
  ElementMesh mesh;
  add_grid(mesh, {0, 0, 0}, kX, kY, 1, 1, {glm::dvec3{0.5}, glm::dvec3{0.0}});
  add_grid(mesh, kZ, kY, kX, 1, 1, {glm::dvec3{0.0}, glm::dvec3{1.0}});
  // A sheet between them that turns its back, white and glowing, to the floor.
  add_grid(mesh, {-9, -9, 0.5}, 20.0 * kX, 20.0 * kY, 1, 1, {glm::dvec3{0.9}, glm::dvec3{1.0}});
  const PathTracedRadiosity traced = path_traced_radiosity(mesh);
  EXPECT_EQ(traced.mean[0], glm::dvec3{0.0});
}

TEST(PathTracer, AgreesWithRadiosityOnARefinedCube) {
  const Paint floor{{0.5, 0.9, 0.1}, {1.0, 0.5, 2.0}};
  const Paint walls{{0.7, 0.9, 0.2}, glm::dvec3{0.0}};
  const ElementMesh fine = unit_cube(10, floor, walls);
  const std::vector<glm::dvec3> expected = face_means(fine, solve_radiosity(fine, form_factors(fine)));
  const ElementMesh coarse = unit_cube(1, floor, walls);
  PathTracingOptions options;
  options.paths_per_element = 65536;
  const PathTracedRadiosity traced = path_traced_radiosity(coarse, options);
  constexpr double kMeshError = 2e-3;  // of 10 x 10 constant elements a face
  for (std::size_t face = 0; face < 6; ++face) {
    for (glm::length_t channel = 0; channel < 3; ++channel) {
      const double error = traced.standard_error[face][channel];
      EXPECT_LT(error, 5e-3 * expected[face][channel]);
      EXPECT_NEAR(traced.mean[face][channel], expected[face][channel],
                  3.0 * error + kMeshError * expected[face][channel])
          << face << ' ' << channel;
    }
  }
}

TEST(PathTracer, AgreesWithRadiosityWhereASheetCastsAShadow) {
  const Paint grey{glm::dvec3{0.7}, glm::dvec3{0.0}};
  const auto room = [&](int n) {
    ElementMesh mesh = unit_cube(n, grey, grey);
    add_grid(mesh, {0.25, 0.25, 0.5}, 0.5 * kX, 0.5 * kY, n, n, grey);
    add_grid(mesh, {0.25, 0.25, 0.5}, 0.5 * kY, 0.5 * kX, n, n, grey);
    add_grid(mesh, {0.4, 0.4, 0.95}, 0.2 * kY, 0.2 * kX, n, n, {glm::dvec3{0.0}, glm::dvec3{10.0}});
    return mesh;
  };
  const ElementMesh fine = room(8);
  const ElementMesh coarse = room(1);
  const std::vector<glm::dvec3> expected = face_means(fine, solve_radiosity(fine, form_factors(fine)));
  PathTracingOptions options;
  options.paths_per_element = 65536;
  const PathTracedRadiosity traced = path_traced_radiosity(coarse, options);
  constexpr double kMeshError = 5e-3;  // of 8 x 8 constant elements a face, at the edge of a shadow
  for (std::size_t face = 0; face < expected.size(); ++face) {
    const double error = traced.standard_error[face].x;
    EXPECT_LT(error, 5e-3 * expected[face].x);
    EXPECT_NEAR(traced.mean[face].x, expected[face].x, 3.0 * error + kMeshError * expected[face].x) << face;
  }
}

TEST(PathTracer, DoesNotDependOnTheNumberOfThreads) {
  const ElementMesh mesh =
      unit_cube(2, {glm::dvec3{0.5}, glm::dvec3{1.0}}, {glm::dvec3{0.5}, glm::dvec3{0.0}});
  PathTracingOptions options;
  options.paths_per_element = 256;
  const PathTracedRadiosity parallel = path_traced_radiosity(mesh, options);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const PathTracedRadiosity serial = path_traced_radiosity(mesh, options);
  EXPECT_EQ(serial.mean, parallel.mean);
  EXPECT_EQ(serial.standard_error, parallel.standard_error);
}

TEST(PathTracer, RefusesTooFewPathsOrBatches) {
  const ElementMesh mesh = unit_cube(1, {}, {});
  EXPECT_THROW(path_traced_radiosity(mesh, {0, 16, 1}), std::invalid_argument);
  EXPECT_THROW(path_traced_radiosity(mesh, {16, 1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/reference/ray_cast_shooting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "host_sim/reference/radiosity.h"
#include "tests/reference/grid_mesh.h"

namespace fixrad::host {
namespace {

const glm::dvec3 kX{1, 0, 0};
const glm::dvec3 kY{0, 1, 0};
const glm::dvec3 kZ{0, 0, 1};
const Paint kGrey{glm::dvec3{0.5}, glm::dvec3{0.0}};
const Paint kLamp{glm::dvec3{0.0}, glm::dvec3{1.0}};

RayCastOptions with_rays(std::uint32_t rays, bool keep_pairs = true) {
  RayCastOptions options;
  options.rays = rays;
  options.keep_pairs = keep_pairs;
  return options;
}

TEST(RayCastShooting, FindsTheFormFactorOfParallelAndOfTouchingSquares) {
  const std::pair<glm::dvec3, double> cases[] = {{kX, 0.19982489569838746}, {kZ, 0.20004377607540316}};
  for (const auto& [up, factor] : cases) {
    ElementMesh mesh;
    add_grid(mesh, {0, 0, 0}, kX, kY, 4, 4, kGrey);
    add_grid(mesh, up == kX ? kZ : glm::dvec3{0.0}, kY, up, 4, 4, kLamp);
    const std::vector<glm::dvec3> means = face_means(mesh, ray_cast_shooting(mesh, with_rays(32)).radiosity);
    EXPECT_NEAR(means[0].x, 0.5 * factor, 0.01 * factor);
  }
}

TEST(RayCastShooting, AFurnaceHasItsClosedForm) {
  const Paint paint{glm::dvec3{0.5}, {1.0, 2.0, 0.0}};
  for (const bool keep_pairs : {false, true}) {
    const ElementMesh mesh = unit_cube(5, paint, paint);
    for (const glm::dvec3& mean :
         face_means(mesh, ray_cast_shooting(mesh, with_rays(16, keep_pairs)).radiosity)) {
      EXPECT_NEAR(mean.x, 2.0, 0.02);
      EXPECT_NEAR(mean.y, 4.0, 0.04);
      EXPECT_EQ(mean.z, 0.0);
    }
  }
}

TEST(RayCastShooting, KeptPairsAreCastOnce) {
  const ElementMesh mesh = unit_cube(4, kLamp, kGrey);
  const RayCastResult kept = ray_cast_shooting(mesh, with_rays(4, true));
  const RayCastResult anew = ray_cast_shooting(mesh, with_rays(4, false));
  EXPECT_LE(kept.pairs, mesh.elements.size() * (mesh.elements.size() + 1) / 2);
  EXPECT_EQ(anew.pairs, std::uint64_t{anew.shots} * mesh.elements.size());
}

TEST(RayCastShooting, ASheetBetweenBlocksFromItsBackToo) {
  for (const bool shows_its_back : {false, true}) {
    ElementMesh mesh;
    add_grid(mesh, {0, 0, 0}, kX, kY, 2, 2, kGrey);
    add_grid(mesh, kZ, kY, kX, 2, 2, kLamp);
    add_grid(mesh, {-9, -9, 0.5}, 20.0 * (shows_its_back ? kX : kY), 20.0 * (shows_its_back ? kY : kX), 1, 1,
             {});
    for (std::size_t e = 0; e < 4; ++e) {
      EXPECT_EQ(ray_cast_shooting(mesh, with_rays(8)).radiosity[e], glm::dvec3{0.0});
    }
  }
}

TEST(RayCastShooting, RefusesNumbersOfRaysThatItDoesNotTake) {
  const ElementMesh mesh = unit_cube(1, kLamp, kGrey);
  EXPECT_THROW(ray_cast_shooting(mesh, with_rays(0)), std::invalid_argument);
  EXPECT_THROW(ray_cast_shooting(mesh, with_rays(33)), std::invalid_argument);
}

}  // namespace
}  // namespace fixrad::host

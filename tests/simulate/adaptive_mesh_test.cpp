// SPDX-License-Identifier: MIT
#include "host_sim/simulate/adaptive_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "host_sim/simulate/eye_sights.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

struct Adaptive {
  Model model;
  PreparedScene prepared;
  Meshing meshing;
  DeviceScene device;

  Adaptive(const Model& scene, std::uint32_t elements) : model(scene), prepared(prepare(model)) {
    meshing = make_adaptive(prepared, elements, elements / 4);
    device = make_device_scene(prepared, meshing);
  }
  Adaptive(const Adaptive&) = delete;  // `prepared` points at `model`
  Adaptive& operator=(const Adaptive&) = delete;
};

double face_area(const DeviceScene& device, std::uint32_t face) {
  double sum = 0;
  for (const MeshElement& e : device.mesh.elements) {
    sum += e.plane == face ? e.area : 0;
  }
  return sum;
}

TEST(AdaptiveMesh, UsesTheElementsItMayHaveAndLeavesNoPartOfAFaceOut) {
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
    const Adaptive mesh(random_closed_room(seed), 200);
    EXPECT_EQ(mesh.device.elements.size(), mesh.meshing.element_count);
    EXPECT_LE(mesh.device.elements.size(), 200u);
    EXPECT_GE(mesh.device.elements.size(), 190u);
    const DeviceScene whole = make_device_scene(mesh.prepared, make_uniform(mesh.prepared, 30, 30));
    for (std::uint32_t f = 0; f < mesh.device.faces.size(); ++f) {
      const double area = face_area(whole, f);
      EXPECT_NEAR(face_area(mesh.device, f), area, 1e-6 * area) << "seed " << seed << ", face " << f;
    }
  }
}

TEST(AdaptiveMesh, GivesASceneTheCoreAcceptsAndSolvesWithoutLoss) {
  for (const std::uint32_t seed : {5u, 6u}) {
    Adaptive mesh(random_closed_room(seed), 250);
    Settings settings = lune_settings(32, fraction(1, 1000));
    settings.overshoot = true;
    settings.flux_per_eye = fraction(1, 2000);  // as many eyes as there are; none may leave its element
    const Sizes sizes = sizes_for(mesh.device, 0, settings);
    find_sights(mesh.device, sizes);
    SimulatedDevice solver(sizes);
    ASSERT_EQ(solver.load(mesh.device.view(), settings), Status::ok);
    Status status = Status::ok;
    while (status == Status::ok) {
      status = shoot(solver.state());
    }
    EXPECT_EQ(status, Status::converged);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(ledger(solver.state(), c).imbalance(), 0);
      EXPECT_EQ(ledger(solver.state(), c).escaped, 0);
    }
  }
}

// A lamp over one corner of a table top: light falls off with the distance from it.
TEST(AdaptiveMesh, HasItsSmallElementsWhereTheLightChanges) {
  ModelBuilder builder;
  const std::uint32_t grey = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.0), glm::dvec3(10.0));
  builder.polygon({{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}}, grey);
  builder.polygon({{0.2, 0.5, 0.2}, {0.6, 0.5, 0.2}, {0.6, 0.5, 0.6}, {0.2, 0.5, 0.6}}, lamp);
  const Adaptive mesh(builder.model(), 120);
  double near_area = 0, far_area = 0;
  int near_count = 0, far_count = 0;
  for (const MeshElement& e : mesh.device.mesh.elements) {
    const double distance = std::hypot(e.centroid.x - 0.4, e.centroid.z - 0.4);
    if (e.centroid.y < 0.1 && distance < 1.2) {
      near_area += e.area;
      ++near_count;
    } else if (e.centroid.y < 0.1 && distance > 2.5) {
      far_area += e.area;
      ++far_count;
    }
  }
  ASSERT_GT(near_count, 10);
  ASSERT_GT(far_count, 2);
  EXPECT_LT(3 * near_area / near_count, far_area / far_count);
}

TEST(AdaptiveMesh, CutsTheFloorAlongTheFeetOfABox) {
  const Adaptive mesh(room_with_box(Stand::closed_on_floor, 0.3), 220);
  // No element of the floor lies half under the box: its corners are all within or all without.
  const double c = std::cos(0.3), s = std::sin(0.3);
  double across = 0;
  for (const MeshElement& e : mesh.device.mesh.elements) {
    double inside = 0, outside = 0;
    for (const glm::dvec3& p : e.polygon) {
      const double x = c * (p.x - 2) - s * (p.z - 2), z = s * (p.x - 2) + c * (p.z - 2);
      const double depth = 0.5 - std::max(std::abs(x), std::abs(z));
      inside = std::max(inside, p.y < 1e-3 ? depth : 0);
      outside = std::max(outside, -depth);
    }
    across += inside > 0.02 && outside > 0.02 ? e.area : 0;
  }
  EXPECT_LT(across, 0.1) << "of 16 square metres";
}

TEST(AdaptiveMesh, IsTheSameEveryTime) {
  const Adaptive once(cornell(), 180), again(cornell(), 180);
  ASSERT_EQ(once.device.elements.size(), again.device.elements.size());
  for (std::size_t e = 0; e < once.device.elements.size(); ++e) {
    EXPECT_EQ(once.device.mesh.elements[e].polygon, again.device.mesh.elements[e].polygon);
  }
}

TEST(ContactMesh, StaysWithinItsNumberOfElements) {
  const Model model = cornell();
  const PreparedScene prepared = prepare(model);
  for (const std::uint32_t elements : {20u, 60u, 150u, 400u}) {
    const Meshing mesh = make_contact_mesh(prepared, elements, elements);
    EXPECT_LE(mesh.element_count, elements);
    EXPECT_EQ(make_device_scene(prepared, mesh).elements.size(), mesh.element_count);
  }
}

}  // namespace
}  // namespace fixrad::host

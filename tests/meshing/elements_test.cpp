// SPDX-License-Identifier: MIT
// Uniform meshing and the device's records.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "host_sim/meshing/device_scene.h"
#include "lib/scene/load.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

constexpr double kAreaTolerance = 2e-3;  // relative: corners are rounded to the grid

struct Meshed {
  Meshed(Model m, std::uint32_t elements, std::uint32_t patches)
      : model(std::move(m)),
        prepared(prepare(model)),
        meshing(make_uniform(prepared, elements, patches)),
        device(make_device_scene(prepared, meshing)) {}
  Meshed(const Meshed&) = delete;
  Meshed& operator=(const Meshed&) = delete;

  Model model;
  PreparedScene prepared;
  Meshing meshing;
  DeviceScene device;
};

Model odd_shapes() {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.polygon({{0, 0, 0}, {0, 0, 2}, {1, 0, 2}, {1, 0, 1}, {2, 0, 1}, {2, 0, 0}}, 0);
  builder.polygon({{0, 1, 0}, {1, 1, 0}, {1.4, 1, 0.8}, {0.4, 1, 1.3}, {-0.3, 1, 0.7}}, 0);
  builder.polygon({{0, 2, 0}, {3, 2.1, 0.2}, {0.1, 2.3, 1}}, 0);
  return builder.model();
}

std::vector<Model> models() {
  return {cornell(), odd_shapes(), random_closed_room(3), random_open_room(4),
          room_with_box(Stand::floating, 0.4)};
}

TEST(Elements, AreasSumToTheFaces) {
  for (const Model& model : models()) {
    const Meshed meshed(model, 250, 250);
    std::vector<double> sum(meshed.prepared.faces.size(), 0.0);
    for (const MeshElement& element : meshed.device.mesh.elements) {
      sum[element.plane] += element.area;
    }
    for (std::size_t f = 0; f < sum.size(); ++f) {
      const double grid_area =
          area(meshed.prepared.frames[f].outline) * meshed.prepared.frames[f].unit_area();
      EXPECT_NEAR(sum[f] * std::pow(meshed.device.grid.scale, 2) / grid_area, 1.0, 1e-9);
    }
  }
}

TEST(Elements, OverlapsSumToTheInputFaces) {
  for (const Model& model : models()) {
    const Meshed meshed(model, 250, 250);
    std::vector<double> sum(model.faces.size(), 0.0);
    for (const Overlap& overlap : meshed.device.overlaps) {
      sum[overlap.input_face] += overlap.area;
    }
    const std::vector<double> areas = face_areas(model);
    for (std::size_t f = 0; f < sum.size(); ++f) {
      EXPECT_NEAR(sum[f] / areas[f], 1.0, kAreaTolerance) << "face " << f;
    }
  }
}

// Their areas sum to the face's (above), so without an overlap there is no hole either.
TEST(Elements, DoNotOverlap) {
  for (const Model& model : models()) {
    const Meshed meshed(model, 250, 250);
    for (std::size_t f = 0; f < meshed.prepared.faces.size(); ++f) {
      const std::vector<CellElement>& elements = meshed.meshing.faces[f].elements;
      double overlap = 0;
      for (std::size_t a = 0; a < elements.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          const Polygon2d common = intersect(elements[a].outline, elements[b].outline);
          overlap += common.size() >= 3 ? std::abs(area(common)) : 0.0;
        }
      }
      EXPECT_LT(overlap, 1e-9);
    }
  }
}

TEST(Elements, AreAboutOfOneSize) {
  const Meshed meshed(cube(0.5, {1, 1, 1, 1, 1, 1}), 600, 600);
  EXPECT_EQ(meshed.device.elements.size(), 600u);
  for (const MeshElement& element : meshed.device.mesh.elements) {
    EXPECT_NEAR(element.area, 0.01, 1e-6);
  }
}

TEST(Elements, AreNeverMoreThanAskedUnlessFacesAre) {
  for (const Model& model : models()) {
    for (const std::uint32_t wanted : {1u, 30u, 100u, 264u, 1000u}) {
      const Meshed meshed(model, wanted, wanted);
      const std::size_t most = std::max<std::size_t>(wanted, meshed.prepared.faces.size());
      EXPECT_LE(meshed.device.elements.size(), most);
      EXPECT_GE(meshed.device.elements.size(), meshed.prepared.faces.size());
      EXPECT_EQ(meshed.meshing.element_count, meshed.device.elements.size());
      if (wanted >= 264) {
        EXPECT_GT(meshed.device.elements.size(), wanted * 7 / 10) << "nearly all that was asked for";
      }
    }
  }
}

TEST(Elements, HaveCentroidsOnTheirPlaneAndInside) {
  const Meshed meshed(odd_shapes(), 100, 100);
  for (const MeshElement& element : meshed.device.mesh.elements) {
    for (std::size_t i = 0; i < element.polygon.size(); ++i) {
      const glm::dvec3 a = element.polygon[i], b = element.polygon[(i + 1) % element.polygon.size()];
      EXPECT_GE(glm::dot(element.normal, glm::cross(b - a, element.centroid - a)), -1e-9);
      EXPECT_NEAR(glm::dot(element.normal, a - element.centroid), 0.0, 1e-9);
    }
  }
}

TEST(Patches, PartitionTheElements) {
  for (const Model& model : models()) {
    const Meshed meshed(model, 250, 60);
    std::vector<std::uint16_t> members = meshed.device.patch_elements;
    std::sort(members.begin(), members.end());
    std::vector<std::uint16_t> all(meshed.device.elements.size());
    std::iota(all.begin(), all.end(), std::uint16_t{0});
    EXPECT_EQ(members, all);
    for (std::size_t p = 0; p < meshed.device.patches.size(); ++p) {
      const Patch& patch = meshed.device.patches[p];
      for (unsigned i = 0; i < patch.element_count; ++i) {
        const Element& element =
            meshed.device.elements[meshed.device.patch_elements[patch.first_element + i]];
        EXPECT_EQ(element.patch, p);
        EXPECT_EQ(element.face, patch.face);
      }
    }
  }
}

TEST(Patches, AreNotMoreThanAskedWhereGroupingCanDoIt) {
  const Meshed meshed(cornell(), 264, 97);
  EXPECT_LE(meshed.device.patches.size(), 97u);
  EXPECT_GT(meshed.device.patches.size(), 30u);
}

TEST(DeviceScene, IsAcceptedByTheCore) {
  for (const Model& model : models()) {
    for (const std::uint32_t elements : {20u, 250u, 1500u}) {
      const Meshed meshed(model, elements, elements / 2);
      const Status status = check_scene(meshed.device.view(), {65535, 65535, 65535, 3});
      EXPECT_EQ(status, Status::ok) << static_cast<int>(status);
    }
  }
}

TEST(DeviceScene, CarriesOneChannelIfEverythingIsGrey) {
  EXPECT_EQ(Meshed(cube(0.5, {1, 0, 0, 0, 0, 0}), 20, 20).device.channels, 1);
  EXPECT_EQ(Meshed(cornell(), 30, 30).device.channels, 3);
}

TEST(DeviceScene, KeepsEmittedPowerInItsUnit) {
  const Meshed meshed(cube(0.9, {3, 0, 0, 0.01, 0, 0}), 150, 150);
  double watts = 0;
  for (const Element& element : meshed.device.elements) {
    watts +=
        emitted_flux(meshed.device.view(), meshed.device.materials[element.material], element.area, 0).raw *
        meshed.device.unit_watts;
  }
  EXPECT_NEAR(watts, 3.01, 3.01 * 1e-5);
}

TEST(FaceMeans, OfAConstantFieldAreConstant) {
  for (const Model& model : models()) {
    const Meshed meshed(model, 200, 200);
    const std::vector<glm::dvec3> field(meshed.device.elements.size(), glm::dvec3(2.0, 0.5, 7.0));
    for (const glm::dvec3& mean : face_means(model, meshed.device.overlaps, field)) {
      EXPECT_NEAR(glm::distance(mean, glm::dvec3(2.0, 0.5, 7.0)), 0.0, 1e-9);
    }
  }
}

TEST(FaceMeans, OfALinearFieldAreItsValuesAtTheCentroids) {
  const Meshed meshed(cornell(), 300, 300);
  const auto value = [](glm::dvec3 p) { return 1000.0 + p.x + 2 * p.y - p.z; };
  std::vector<glm::dvec3> field;
  for (const MeshElement& element : meshed.device.mesh.elements) {
    field.emplace_back(value(element.centroid));
  }
  const std::vector<glm::dvec3> means = face_means(meshed.model, meshed.device.overlaps, field);
  for (std::size_t f = 0; f < means.size(); ++f) {
    const std::vector<std::uint32_t>& corners = meshed.model.faces[f].corners;
    glm::dvec3 centroid(0.0);
    double weight = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const glm::dvec3 a = meshed.model.positions[corners[0]], b = meshed.model.positions[corners[i]],
                       c = meshed.model.positions[corners[i + 1]];
      const double w = glm::length(glm::cross(b - a, c - a));
      centroid += w * (a + b + c) / 3.0;
      weight += w;
    }
    EXPECT_NEAR(means[f].x / value(centroid / weight), 1.0, 1e-3) << "face " << f;
  }
}

TEST(FaceMeans, GiveAFaceWithoutElementsItsOwnEmission) {
  Model model = cube(0.5, {1, 0, 0, 0, 0, 0});
  Face collapsed = model.faces[0];
  collapsed.corners = {0, 1, 0};
  model.faces.push_back(collapsed);
  const Meshed meshed(model, 30, 30);
  EXPECT_EQ(meshed.prepared.warnings.size(), 1u);
  const std::vector<glm::dvec3> field(meshed.device.elements.size(), glm::dvec3(5.0));
  EXPECT_EQ(face_means(model, meshed.device.overlaps, field).back(), glm::dvec3(1.0));
}

TEST(Prepare, RefusesASceneWhoseLampHasNoAreaOnTheGrid) {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.room(glm::dvec3(0.0), glm::dvec3(1e6), {wall, wall, wall, wall, wall, wall});
  builder.polygon({{1, 1, 1}, {2, 1, 1}, {2, 2, 1}}, lamp);
  const Model model = builder.model();
  EXPECT_THROW(prepare(model), InputError);
}

// Seven corners within a grid unit of a line: the face that they bound must keep axes that span it.
TEST(Prepare, GivesASliverAFrameThatTheCoreTakes) {
  const double e = 1.0 / kGridMax;
  for (const double width : {0.3, 0.6, 1.0, 1.6, 2.5}) {
    ModelBuilder builder;
    const std::uint32_t lamp = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
    builder.room(glm::dvec3(0.0), glm::dvec3(1.0), {lamp, lamp, lamp, lamp, lamp, lamp});
    builder.polygon({{0.2, 0.5, 0.5},
                     {0.3, 0.5, 0.5},
                     {0.4, 0.5, 0.5},
                     {0.4, 0.5 + width * e, 0.5 + width * e},
                     {0.2, 0.5 + width * e, 0.5 + width * e}},
                    lamp);
    const Model model = builder.model();
    const PreparedScene scene = prepare(model);
    const DeviceScene device = make_device_scene(scene, make_uniform(scene, 50, 50));
    EXPECT_EQ(check_scene(device.view(), {65535, 65535, 65535, 3}), Status::ok) << width;
  }
}

}  // namespace
}  // namespace fixrad::host

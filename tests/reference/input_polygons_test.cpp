// SPDX-License-Identifier: MIT
#include "host_sim/reference/input_polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "host_sim/io/obj_reader.h"

namespace fixrad::host {
namespace {

std::vector<double> areas_of(const std::vector<MeshElement>& polygons, std::size_t faces) {
  std::vector<double> areas(faces, 0.0);
  for (const MeshElement& polygon : polygons) {
    areas[polygon.input_face] += polygon.area;
  }
  return areas;
}

TEST(InputPolygons, CoverEachFaceOfEachSampleScene) {
  for (const char* name : {"cornell", "furnished_room", "colonnade", "gap", "portico"}) {
    const Model model = read_obj(std::string(FIXRAD_SOURCE_DIR) + "/scenes/" + name + ".obj");
    const std::vector<double> areas = areas_of(input_polygons(prepare(model)), model.faces.size());
    const std::vector<double> expected = face_areas(model);
    for (std::size_t f = 0; f < areas.size(); ++f) {
      EXPECT_NEAR(areas[f], expected[f], 1e-9 * expected[f]) << name << ' ' << f;
    }
  }
}

/// A square of side 1 and, far away, what gives the scene its size.
Model two_faces(const std::vector<glm::dvec3>& corners) {
  Model model;
  model.materials.push_back({"grey", glm::dvec3{0.5}, glm::dvec3{0.0}});
  model.positions = corners;
  Face face;
  for (std::uint32_t v = 0; v < corners.size(); ++v) {
    face.corners.push_back(v);
  }
  model.faces.push_back(face);
  model.positions.insert(model.positions.end(), {{0, 0, 100}, {100, 0, 100}, {0, 100, 100}});
  const auto n = static_cast<std::uint32_t>(corners.size());
  Face far;
  far.corners = {n, n + 1, n + 2};
  model.faces.push_back(far);
  model.file_faces = model.faces.size();
  return model;
}

TEST(InputPolygons, KeepCornersThatTheDeviceGridWouldRound) {
  const Model model = two_faces({{0, 0, 0}, {1.001, 0, 0}, {1.001, 1, 0}, {0, 1, 0}});
  const std::vector<MeshElement> polygons = input_polygons(prepare(model));
  EXPECT_NEAR(areas_of(polygons, 2)[0], 1.001, 1e-12);
}

TEST(InputPolygons, IncludeAFaceThatCollapsesOnTheGrid) {
  const Model model = two_faces({{0, 0, 0}, {1, 0, 0}, {1, 1e-4, 0}, {0, 1e-4, 0}});
  const PreparedScene scene = prepare(model);
  ASSERT_EQ(scene.faces.size(), 1U);
  EXPECT_NEAR(areas_of(input_polygons(scene), 2)[0], 1e-4, 1e-12);
}

TEST(InputPolygons, CutAConcaveFaceIntoPiecesOfItsArea) {
  const Model model = two_faces({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {10, 20, 0}, {10, 10, 0}, {0, 10, 0}});
  const std::vector<MeshElement> polygons = input_polygons(prepare(model));
  EXPECT_NEAR(areas_of(polygons, 2)[0], 300.0, 1e-9);
  EXPECT_GT(polygons.size(), 2U);
}

TEST(InputPolygons, CutATwistedQuadrilateralIntoTrianglesWithTheirOwnNormals) {
  // Flat to the device's grid, not to a ray: 1e-3 over 100 is a sixth of a grid unit.
  const Model model = two_faces({{0, 0, 0}, {10, 0, 0}, {10, 10, 1e-3}, {0, 10, 0}});
  const std::vector<MeshElement> polygons = input_polygons(prepare(model));
  ASSERT_EQ(polygons.size(), 3U);
  for (const MeshElement& polygon : polygons) {
    EXPECT_EQ(polygon.polygon.size(), 3U);
    for (const glm::dvec3& corner : polygon.polygon) {
      EXPECT_LT(std::abs(glm::dot(corner - polygon.centroid, polygon.normal)), 1e-12);
    }
  }
}

}  // namespace
}  // namespace fixrad::host

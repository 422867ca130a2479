// SPDX-License-Identifier: MIT
#include "host_sim/meshing/convex_faces.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "host_sim/meshing/device_scene.h"
#include "lib/scene/shape.h"
#include "tests/lib/scenes.h"

namespace fixrad::host {
namespace {

Model model_of(const std::vector<std::vector<glm::dvec3>>& polygons) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  for (const std::vector<glm::dvec3>& corners : polygons) {
    builder.polygon(corners, 0);
  }
  return builder.model();
}

ConvexFaces convex_of(const Model& model, QuantisedVertices& vertices) {
  vertices = quantise(model);
  return make_convex(model, vertices);
}

// Square scene units.
double area_of(const QuantisedVertices& vertices, const std::vector<std::uint32_t>& corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const glm::dvec3 base(vertices.positions[corners[0]]);
    sum += glm::cross(glm::dvec3(vertices.positions[corners[i]]) - base,
                      glm::dvec3(vertices.positions[corners[i + 1]]) - base);
  }
  return glm::length(sum) / 2 / (vertices.grid.scale * vertices.grid.scale);
}

double total_area(const QuantisedVertices& vertices, const ConvexFaces& convex) {
  double sum = 0;
  for (const ConvexFace& face : convex.faces) {
    sum += area_of(vertices, face.corners);
  }
  return sum;
}

constexpr double kAreaTolerance = 1e-3;  // corners move by a grid unit of 1/16000

TEST(MakeConvex, KeepsAConvexPlanarFace) {
  QuantisedVertices vertices;
  const ConvexFaces convex = convex_of(cube(0.5, {1, 0, 0, 0, 0, 0}), vertices);
  ASSERT_EQ(convex.faces.size(), 6u);
  for (std::size_t f = 0; f < 6; ++f) {
    EXPECT_EQ(convex.faces[f].corners.size(), 4u);
    EXPECT_EQ(convex.faces[f].parts.front().input_face, f);
  }
  EXPECT_THAT(convex.warnings, testing::IsEmpty());
}

TEST(MakeConvex, CutsAConcavePolygonAndKeepsItsAreaAndSide) {
  const Model model =
      model_of({{{0, 0, 0}, {0, 0, 2}, {1, 0, 2}, {1, 0, 1}, {2, 0, 1}, {2, 0, 0}}});  // an L, 3 m2
  QuantisedVertices vertices;
  const ConvexFaces convex = convex_of(model, vertices);
  EXPECT_GE(convex.faces.size(), 2u);
  EXPECT_NEAR(total_area(vertices, convex), 3.0, kAreaTolerance);
  for (const ConvexFace& face : convex.faces) {
    EXPECT_TRUE(is_convex_and_planar(vertices, face.corners));
    EXPECT_GT(face.normal.y, 0.999);
  }
}

TEST(MakeConvex, CutsAPolygonOfManyCorners) {
  std::vector<glm::dvec3> disc;
  for (int i = 0; i < 40; ++i) {
    disc.emplace_back(std::sin(i * 3.14159265358979 / 20), 0.0, std::cos(i * 3.14159265358979 / 20));
  }
  QuantisedVertices vertices;
  const ConvexFaces convex = convex_of(model_of({disc}), vertices);
  for (const ConvexFace& face : convex.faces) {
    EXPECT_LE(face.corners.size(), static_cast<std::size_t>(kMaxCorners));
    EXPECT_GT(face.normal.y, 0.999);
  }
  EXPECT_NEAR(total_area(vertices, convex), 20 * std::sin(3.14159265358979 / 20), kAreaTolerance);
}

TEST(MakeConvex, SplitsAQuadThatIsNotPlanar) {
  QuantisedVertices vertices;
  const ConvexFaces convex = convex_of(model_of({{{0, 0, 0}, {0, 0, 1}, {1, 0.2, 1}, {1, 0, 0}}}), vertices);
  ASSERT_EQ(convex.faces.size(), 2u);
  EXPECT_EQ(convex.faces[0].corners.size() + convex.faces[1].corners.size(), 6u);
}

TEST(MakeConvex, DropsFacesWithoutAreaWithOneWarning) {
  const std::vector<glm::dvec3> whole = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
  const Model model = model_of({whole,
                                {{0, 0, 0}, {0, 0, 0.5}, {0, 0, 1}},
                                {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                                {{0, 0, 0}, {1e-7, 0, 0}, {0, 0, 1e-7}}});
  QuantisedVertices vertices;
  const ConvexFaces convex = convex_of(model, vertices);
  EXPECT_EQ(convex.faces.size(), 1u);
  ASSERT_EQ(convex.warnings.size(), 1u);
  EXPECT_THAT(convex.warnings[0], testing::StartsWith("test:2: warning: 3 face(s)"));
}

TEST(MakeConvex, ForgivesARepeatedCorner) {
  QuantisedVertices vertices;
  const ConvexFaces convex =
      convex_of(model_of({{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}}), vertices);
  ASSERT_EQ(convex.faces.size(), 1u);
  EXPECT_EQ(convex.faces[0].corners.size(), 4u);
}

TEST(MergeCoplanar, MakesOneRectangleOfATriangulatedWall) {
  ModelBuilder builder;
  builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}}, 0);
  builder.polygon({{0, 0, 0}, {1, 0, 1}, {1, 0, 0}}, 0);
  QuantisedVertices vertices;
  ConvexFaces convex = convex_of(builder.model(), vertices);
  ASSERT_EQ(convex.faces.size(), 2u);
  merge_coplanar(vertices, convex);
  ASSERT_EQ(convex.faces.size(), 1u);
  EXPECT_EQ(convex.faces[0].corners.size(), 4u);
  EXPECT_EQ(convex.faces[0].parts.size(), 2u);
  EXPECT_NEAR(total_area(vertices, convex), 1.0, kAreaTolerance);
}

TEST(MergeCoplanar, KeepsMaterialsAndSmoothingGroupsApart) {
  for (const bool same_material : {true, false}) {
    ModelBuilder builder;
    builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
    builder.material(glm::dvec3(0.4));
    builder.polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, 0);
    builder.polygon({{1, 0, 0}, {1, 0, 1}, {2, 0, 1}, {2, 0, 0}}, same_material ? 0 : 1);
    Model model = builder.model();
    QuantisedVertices vertices;
    ConvexFaces convex = convex_of(model, vertices);
    merge_coplanar(vertices, convex);
    EXPECT_EQ(convex.faces.size(), same_material ? 1u : 2u);
    model.faces[1].smoothing_group = 3;
    convex = convex_of(model, vertices);
    merge_coplanar(vertices, convex);
    EXPECT_EQ(convex.faces.size(), 2u);
  }
}

TEST(MergeCoplanar, KeepsAreaAndConvexityOfEveryFace) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const Model model = seed % 2 == 0 ? random_closed_room(seed) : random_open_room(seed);
    QuantisedVertices vertices;
    ConvexFaces convex = convex_of(model, vertices);
    const double before = total_area(vertices, convex);
    merge_coplanar(vertices, convex);
    EXPECT_NEAR(total_area(vertices, convex) / before, 1.0, 1e-9);
    for (const ConvexFace& face : convex.faces) {
      EXPECT_TRUE(is_convex_and_planar(vertices, face.corners));
    }
  }
}

// Every wall of a cube cut into 2 x 2 squares of two triangles each.
Model tessellated_cube() {
  const Model whole = cube(0.5, {1, 0, 0, 0, 0, 0});
  ModelBuilder builder;
  for (const Material& material : whole.materials) {
    builder.material(material.reflectance, material.emission);
  }
  for (const Face& face : whole.faces) {
    const glm::dvec3 o = whole.positions[face.corners[0]];
    const glm::dvec3 u = (whole.positions[face.corners[1]] - o) / 2.0,
                     v = (whole.positions[face.corners[3]] - o) / 2.0;
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 p = o + static_cast<double>(i % 2) * u + static_cast<double>(i / 2) * v;
      builder.polygon({p, p + u, p + u + v}, face.material);
      builder.polygon({p, p + u + v, p + v}, face.material);
    }
  }
  return builder.model();
}

TEST(MergeCoplanar, LeavesAClosedModelClosed) {
  const Model model = tessellated_cube();
  const PreparedScene prepared = prepare(model);
  EXPECT_LT(prepared.faces.size(), 25u) << "48 triangles become a few rectangles";
  const DeviceScene device = make_device_scene(prepared, make_uniform(prepared, 96, 96));
  EXPECT_TRUE(is_closed(device.view()));
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Model room = random_closed_room(seed);
    const PreparedScene scene = prepare(room);
    EXPECT_TRUE(is_closed(make_device_scene(scene, make_uniform(scene, 60, 60)).view()));
  }
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// tinyobjloader as a peer: both readers must agree on good files.
#include <gmock/gmock.h>
#include <tiny_obj_loader.h>

#include <random>
#include <string>

#include "host_sim/io/obj_reader.h"
#include "host_sim/io/text_file.h"
#include "tests/io/read_helpers.h"

namespace fixrad::host {
namespace {

// The peer's own parser of decimal numbers is inexact in the last digits.
constexpr double kRelativeTolerance = 1e-12;

double tolerance(double value) {
  return kRelativeTolerance * std::max(1.0, std::abs(value));
}

struct PeerFace {
  std::vector<std::uint32_t> corners;
  int material = -1;
};

/// The peer's faces in file order: it groups them into shapes, which follow the file.
std::vector<PeerFace> faces_of(const tinyobj::ObjReader& peer) {
  std::vector<PeerFace> faces;
  for (const tinyobj::shape_t& shape : peer.GetShapes()) {
    const tinyobj::mesh_t& mesh = shape.mesh;
    std::size_t first = 0;
    for (std::size_t i = 0; i < mesh.num_face_vertices.size(); ++i) {
      PeerFace& face = faces.emplace_back();
      face.material = mesh.material_ids[i];
      for (std::size_t k = 0; k < mesh.num_face_vertices[i]; ++k) {
        face.corners.push_back(static_cast<std::uint32_t>(mesh.indices[first + k].vertex_index));
      }
      first += mesh.num_face_vertices[i];
    }
  }
  return faces;
}

void expect_equal_material(const Material& material, const tinyobj::material_t& peer) {
  EXPECT_EQ(material.name, peer.name);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(material.reflectance[channel], peer.diffuse[channel], tolerance(peer.diffuse[channel]));
    EXPECT_NEAR(material.emission[channel], peer.emission[channel], tolerance(peer.emission[channel]));
  }
}

void expect_agreement(const std::string& obj, const std::string& mtl) {
  const Model model = read_obj_text(obj, "s.obj", [&](const std::string&) { return std::optional(mtl); });
  tinyobj::ObjReaderConfig config;
  config.triangulate = false;
  tinyobj::ObjReader peer;
  ASSERT_TRUE(peer.ParseFromString(obj, mtl, config)) << peer.Error();

  const std::vector<tinyobj::real_t>& vertices = peer.GetAttrib().vertices;
  ASSERT_EQ(3 * model.positions.size(), vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double coordinate = model.positions[i / 3][static_cast<int>(i % 3)];
    EXPECT_NEAR(coordinate, vertices[i], tolerance(coordinate));
  }
  const std::vector<PeerFace> faces = faces_of(peer);
  ASSERT_EQ(model.faces.size(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    EXPECT_EQ(model.faces[i].corners, faces[i].corners) << "face " << i;
    ASSERT_GE(faces[i].material, 0);
    expect_equal_material(model.materials[model.faces[i].material],
                          peer.GetMaterials()[static_cast<std::size_t>(faces[i].material)]);
  }
}

const char* const kMaterials =
    "newmtl a.b\nKd 0.125 0.3 0.9\nKe 0 0 0\n\nnewmtl lamp\nKd 0 0 0\nKe 12.5 3e2 0.001\nnewmtl c\nKd .7 .7 "
    ".7\n";

/// Polygons of 3 to 20 corners with positive and negative indices in every form, groups and materials between
/// them.
std::string random_scene(std::uint32_t seed, const std::string& line_end) {
  std::mt19937 random(seed);
  const auto below = [&](std::uint32_t n) { return static_cast<int>(random() % n); };
  const char* const usemtl[] = {"usemtl a.b", "usemtl lamp", "usemtl c"};
  const char* const suffix[] = {"", "/1", "//1", "/1/1"};
  std::string text =
      "mtllib m.mtl" + line_end + "vt 0 0" + line_end + "vn 0 0 1" + line_end + "usemtl lamp" + line_end;
  int vertices = 0;
  for (int face = 0; face < 40; ++face) {
    const int corners = 3 + below(18);
    for (int i = 0; i < corners; ++i) {
      text += "v " + std::to_string(below(2000) - 1000) + "." + std::to_string(below(1000)) + " " +
              std::to_string(below(100)) + "e-" + std::to_string(below(5)) + "\t" + std::to_string(below(9)) +
              line_end;
    }
    vertices += corners;
    text += face % 7 == 6 ? "g part " + std::to_string(face) + line_end + usemtl[below(3)] + line_end : "";
    text += "f";
    for (int i = 0; i < corners; ++i) {
      const int index = below(2) == 0 ? i - corners : vertices - corners + i + 1;
      text += " " + std::to_string(index) + suffix[face % 4];
    }
    text += line_end;
  }
  return text;
}

TEST(ObjPeer, AgreesOnTheCornellBox) {
  expect_agreement(read_text_file(FIXRAD_SOURCE_DIR "/scenes/cornell.obj"),
                   read_text_file(FIXRAD_SOURCE_DIR "/scenes/cornell.mtl"));
}

TEST(ObjPeer, AgreesOnRandomPolygons) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    expect_agreement(random_scene(seed, seed % 2 == 0 ? "\n" : "\r\n"), kMaterials);
  }
}

}  // namespace
}  // namespace fixrad::host

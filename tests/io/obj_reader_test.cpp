// SPDX-License-Identifier: MIT
// Good files, as modelling tools write them. Expectations follow the text of the OBJ specification.
#include "host_sim/io/obj_reader.h"

#include <gmock/gmock.h>

#include "tests/io/read_helpers.h"

namespace fixrad::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ObjReader, ReadsPositionsFacesMaterialsAndLines) {
  const Model model = read(lit_square("usemtl white\nf 3 2 1\n"));
  EXPECT_EQ(model.path, "s.obj");
  ASSERT_EQ(model.positions.size(), 4U);
  EXPECT_EQ(model.positions[2], glm::dvec3(1, 1, 0));
  ASSERT_EQ(model.faces.size(), 2U);
  EXPECT_EQ(model.file_faces, 2U);
  EXPECT_THAT(model.faces[0].corners, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(model.faces[1].corners, ElementsAre(2, 1, 0));
  EXPECT_EQ(model.faces[0].line, 7);
  EXPECT_EQ(model.faces[1].line, 9);
  EXPECT_EQ(model.faces[1].material, 1U);
  EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(ObjReader, KeepsOnlyUsedMaterialsInOrderOfFirstUse) {
  const Model model = read(lit_square("usemtl white\nf 1 2 3\nusemtl lamp\nf 2 3 4\n"),
                           {{"m.mtl", std::string("newmtl spare\nKd 7 7 7\n") + kWhiteAndLamp}});
  ASSERT_EQ(model.materials.size(), 2U);
  EXPECT_EQ(model.materials[0].name, "lamp");
  EXPECT_EQ(model.materials[0].emission, glm::dvec3(10, 9, 8));
  EXPECT_EQ(model.materials[1].name, "white");
  EXPECT_EQ(model.materials[1].reflectance, glm::dvec3(0.7, 0.6, 0.5));
  EXPECT_EQ(model.faces[2].material, 0U);
}

TEST(ObjReader, CountsNegativeIndicesBackFromTheLatestVertex) {
  const Model model = read(
      "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl lamp\nf -3 -2 -1\nv 0 1 0\nf -4/-1/-1 -2//-9 -1/1\n");
  EXPECT_THAT(model.faces[0].corners, ElementsAre(0, 1, 2));
  EXPECT_THAT(model.faces[1].corners, ElementsAre(0, 2, 3));
}

TEST(ObjReader, AcceptsEveryFormOfACorner) {
  const Model model = read(lit_square("f 1/2/3 2//3 3/4 4\nf 1/ 2// 3/1/\n"));
  EXPECT_THAT(model.faces[1].corners, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(model.faces[2].corners, ElementsAre(0, 1, 2));
}

TEST(ObjReader, AcceptsFacesAheadOfTheirVertices) {
  const Model model = read(std::string("mtllib m.mtl\nusemtl lamp\nf 1 2 3\n") + kSquare);
  EXPECT_THAT(model.faces[0].corners, ElementsAre(0, 1, 2));
}

TEST(ObjReader, ReadsTheSameFromEveryLineEndAndBlank) {
  const std::string plain = lit_square("usemtl white\nf 1 2 3\n");
  std::string crlf = "\xEF\xBB\xBF# made by a tool\r\n\r\n";
  std::string cr;
  for (const char c : plain) {
    crlf += c == '\n' ? " \t\r\n" : c == ' ' ? "\t " : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  const Model expected = read(plain);
  for (const std::string& text : {crlf, cr, plain.substr(0, plain.size() - 1)}) {
    const Model model = read(text);
    EXPECT_EQ(model.positions, expected.positions);
    ASSERT_EQ(model.faces.size(), 2U);
    EXPECT_EQ(model.faces[1].corners, expected.faces[1].corners);
    EXPECT_EQ(model.materials[1].name, "white");
  }
  EXPECT_EQ(read(crlf).faces[1].line, 11);  // two lines more than plain, where it is line 9
  EXPECT_EQ(read(cr).faces[1].line, 9);
}

TEST(ObjReader, JoinsLinesThatEndInABackslash) {
  const Model model = read(lit_square("f 1 2 \\\r\n  3 \\\n4\nf \\\n1 2 3\n# a comment \\\nf 2 3 4\n"));
  ASSERT_EQ(model.faces.size(), 4U);
  EXPECT_THAT(model.faces[1].corners, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(model.faces[1].line, 8);
  EXPECT_EQ(model.faces[2].line, 11);
  EXPECT_THAT(model.faces[3].corners, ElementsAre(1, 2, 3));
}

TEST(ObjReader, SkipsCommentsAfterAStatement) {
  const Model model = read(lit_square("f 1 2 3 # the half\nf 2 3 4 #other\n  # f 9 9 9\n"));
  EXPECT_EQ(model.faces.size(), 3U);
}

TEST(ObjReader, IgnoresWeightsAndVertexColours) {
  const Model model =
      read("mtllib m.mtl\nv 1 2 3 1.0\nv 4 5 6 0.1 0.2 0.3\nv +7. .5 -1E-2 1 0 0 0\nusemtl lamp\nf 1 2 3\n");
  EXPECT_THAT(model.positions,
              ElementsAre(glm::dvec3(1, 2, 3), glm::dvec3(4, 5, 6), glm::dvec3(7, 0.5, -0.01)));
}

TEST(ObjReader, KeepsSmoothingGroups) {
  const Model model = read(lit_square("s 3\nf 1 2 3\ns off\nf 2 3 4\ns 1\nf 1 2 4\ns 0\nf 1 3 4\n"));
  std::vector<std::uint32_t> groups;
  for (const Face& face : model.faces) {
    groups.push_back(face.smoothing_group);
  }
  EXPECT_THAT(groups, ElementsAre(0, 3, 0, 1, 0));
}

TEST(ObjReader, KeepsPolygonsOfManyCornersWhole) {
  std::string text = "mtllib m.mtl\nusemtl lamp\nf";
  std::string vertices;
  for (int i = 1; i <= 300; ++i) {
    text += " " + std::to_string(i);
    vertices += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
  }
  EXPECT_EQ(read(text + "\n" + vertices).faces[0].corners.size(), 300U);
}

TEST(ObjReader, KeepsFacesWithoutArea) {
  const Model model = read(lit_square("v 2 0 0\nf 1 2 5\nv 0 0 0\nf 1 6 2\n"));
  EXPECT_EQ(model.faces.size(), 3U);
}

TEST(ObjReader, SkipsStatementsWithoutUseSilently) {
  const Model model = read(lit_square("o Room.001\ng a b\nvt 0.5 0.5\nvn 0 0 nan\nvp 1\nmg 1 2\nlod 3\n"));
  EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(ObjReader, WarnsOncePerKindOfUnusedStatement) {
  const Model model = read(lit_square("l 1 2\nl 2 3\np 1\nfrobnicate 1\nfrobnicate 2\n"));
  EXPECT_THAT(model.warnings,
              ElementsAre(HasSubstr("s.obj:8:1: warning: "), HasSubstr("s.obj:10:1: warning: "),
                          HasSubstr("s.obj:11:1: warning: the OBJ statement 'frobnicate'")));
}

TEST(ObjReader, BoundsTheNumberOfWarnings) {
  std::string text = lit_square();
  for (int i = 0; i < 1000; ++i) {
    text += "unknown" + std::to_string(i) + " 1\n";
  }
  const Model model = read(text);
  EXPECT_EQ(model.warnings.size(), 100U);
  EXPECT_THAT(model.warnings.back(), HasSubstr("further warnings are left out"));
}

TEST(ObjReader, FlipReversesEveryFace) {
  ReadOptions options;
  options.flip = true;
  const Model model = read(lit_square("f 1 2 3\n"), {{"m.mtl", kWhiteAndLamp}}, options);
  EXPECT_THAT(model.faces[0].corners, ElementsAre(3, 2, 1, 0));
  EXPECT_THAT(model.faces[1].corners, ElementsAre(2, 1, 0));
}

TEST(ObjReader, TwoSidedAddsReversedTwinsAfterTheFacesOfTheFile) {
  ReadOptions options;
  options.two_sided = true;
  const Model model = read(lit_square("s 2\nusemtl white\nf 1 2 3\n"), {{"m.mtl", kWhiteAndLamp}}, options);
  ASSERT_EQ(model.faces.size(), 4U);
  EXPECT_EQ(model.file_faces, 2U);
  EXPECT_THAT(model.faces[1].corners, ElementsAre(0, 1, 2));
  EXPECT_THAT(model.faces[2].corners, ElementsAre(3, 2, 1, 0));
  EXPECT_THAT(model.faces[3].corners, ElementsAre(2, 1, 0));
  EXPECT_EQ(model.faces[3].material, model.faces[1].material);
  EXPECT_EQ(model.faces[3].smoothing_group, 2U);
  EXPECT_EQ(model.faces[3].line, model.faces[1].line);
}

TEST(ObjReader, GivesFacesWithoutMaterialADefaultWithOneWarning) {
  const Model model =
      read(std::string("mtllib m.mtl\n") + kSquare + "f 1 2 3\nf 2 3 4\nusemtl lamp\nf 1 2 3 4\n");
  ASSERT_EQ(model.materials.size(), 2U);
  EXPECT_EQ(model.materials[0].name, "(default)");
  EXPECT_EQ(model.materials[0].reflectance, glm::dvec3(0.5));
  EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("s.obj:6:1: warning: faces without a usemtl")));
}

TEST(ObjReader, ReadsTheCornellBoxFromItsFiles) {
  const Model model = read_obj(FIXRAD_SOURCE_DIR "/scenes/cornell.obj");
  EXPECT_EQ(model.positions.size(), 28U);
  EXPECT_EQ(model.faces.size(), 20U);
  ASSERT_EQ(model.materials.size(), 4U);
  EXPECT_EQ(model.materials[1].name, "light");
  EXPECT_EQ(model.materials[1].emission, glm::dvec3(53.4070751, 37.6991118, 12.5663706));
  EXPECT_THAT(model.warnings, IsEmpty());
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// Materials: which files are read, what they say, and what is refused.
#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "host_sim/io/obj_reader.h"
#include "tests/io/read_helpers.h"

namespace fixrad::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const char* const kLamp = "newmtl lamp\nKe 1 1 1\n";

std::string error_with(const std::string& mtl) {
  return error_of([&] { read_with_material("a", mtl); });
}

Model read_with_mtllib(const std::string& statements, const Files& files) {
  return read(statements + kSquare + "usemtl lamp\nf 1 2 3 4\n", files);
}

TEST(MtlFiles, NamesMayHaveBlanks) {
  const Model model = read_with_mtllib("mtllib  my room.mtl \n", {{"my room.mtl", kLamp}});
  EXPECT_EQ(model.materials[0].name, "lamp");
}

TEST(MtlFiles, OneStatementMayNameSeveralFiles) {
  const Files files = {{"a.mtl", "newmtl x\n"}, {"b c.mtl", kLamp}, {"d.mtl", "newmtl lamp\nKe 5 5 5\n"}};
  EXPECT_EQ(read_with_mtllib("mtllib a.mtl b c.mtl\n", files).materials[0].emission, glm::dvec3(1.0));
  EXPECT_EQ(read_with_mtllib("mtllib a.mtl b c.mtl d.mtl\n", files).materials[0].emission, glm::dvec3(5.0));
}

TEST(MtlFiles, SeveralStatementsAddUpWhereverTheyStand) {
  const Model model = read(lit_square("usemtl red\nf 1 2 3\nmtllib n.mtl\nmtllib m.mtl\n"),
                           {{"m.mtl", kLamp}, {"n.mtl", "newmtl red\nKd 0.5 0 0\n"}});
  EXPECT_EQ(model.materials[1].reflectance, glm::dvec3(0.5, 0, 0));
  EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(MtlFiles, PathsAreRelativeToTheObjFileAndMayUseBackslashes) {
  std::string asked;
  const auto load = [&](const std::string& path) {
    asked = path;
    return std::optional<std::string>(kLamp);
  };
  read_obj_text(std::string("mtllib .\\sub\\m.mtl\n") + kSquare + "usemtl lamp\nf 1 2 3\n", "scenes/room.obj",
                load);
  EXPECT_EQ(std::filesystem::path(asked).lexically_normal(), "scenes/sub/m.mtl");
}

TEST(MtlFiles, AMissingOneIsAnError) {
  EXPECT_EQ(error_of([] { read_with_mtllib("\nmtllib my room.mtl\n", {}); }),
            "s.obj:2:8: error: there is no material file 'my room.mtl'; put it into the OBJ file's folder or "
            "correct "
            "mtllib");
  EXPECT_THAT(error_of([] {
                read_with_mtllib("mtllib m.mtl gone.mtl\n", {{"m.mtl", kLamp}});
              }),
              StartsWith("s.obj:1:14: error: there is no material file 'gone.mtl'"));
}

TEST(MtlFiles, BinaryOnesAreRefused) {
  EXPECT_THAT(error_of([] {
                read_with_mtllib("mtllib m.mtl\n", {{"m.mtl", std::string("a\0", 2)}});
              }),
              StartsWith("m.mtl: error: is not a text MTL file"));
}

TEST(Materials, NamesMayHaveBlanksAndNumberSigns) {
  for (const char* name : {"01 - Default", "Material #26", "wand gr\xC3\xBCn", "[Color_004]1"}) {
    const Model model =
        read_with_material(std::string(name) + " \t# note", std::string("newmtl\t") + name + "  \r\nKd 0.3");
    EXPECT_EQ(model.materials[1].name, name);
    EXPECT_EQ(model.materials[1].reflectance, glm::dvec3(0.3));
  }
}

TEST(Materials, UndefinedOnesAreRefusedWithTheNamesToChooseFrom) {
  EXPECT_EQ(
      error_of([] { read(lit_square("usemtl whit\nf 1 2 3\n")); }),
      "s.obj:8:8: error: no MTL file defines the material 'whit'; add it or use one of 'white', 'lamp'");
  EXPECT_THAT(error_of([] { read(std::string(kSquare) + "usemtl a\nf 1 2 3\n", {}); }),
              HasSubstr("add an mtllib statement"));
}

TEST(Materials, UndefinedOnesWithoutFacesAreNoError) {
  EXPECT_EQ(read(lit_square("usemtl nowhere\nusemtl white\nf 1 2 3\n")).faces.size(), 2U);
}

TEST(Materials, OneNumberIsGrey) {
  EXPECT_EQ(read_with_material("a", "newmtl a\nKd 0.25\n").materials[1].reflectance, glm::dvec3(0.25));
}

TEST(Materials, WithoutKeEmitNothing) {
  EXPECT_EQ(read_with_material("a", "newmtl a\nKd .1 .2 .3\n").materials[1].emission, glm::dvec3(0.0));
}

TEST(Materials, WithoutKdAreBlackWithAWarning) {
  const Model model = read_with_material("a", "newmtl a\nNs 10\n");
  EXPECT_EQ(model.materials[1].reflectance, glm::dvec3(0.0));
  EXPECT_THAT(model.warnings, ElementsAre(StartsWith("m.mtl:3:1: warning: the material 'a' has no Kd")));
}

TEST(Materials, IlluminationModelTwoAsksForHighlights) {
  const Material a = read_with_material("a", "newmtl a\nKd .5\nKs .1 .2 .3\nNs 40\nillum 2\n").materials[1];
  EXPECT_EQ(a.specular, glm::dvec3(.1, .2, .3));
  EXPECT_EQ(a.exponent, 40);
  EXPECT_FALSE(a.is_mirror);
}

TEST(Materials, IlluminationModelsThreeAndFiveAskForAMirror) {
  for (const char* model : {"3", "5"}) {
    const std::string mtl = std::string("newmtl a\nKd 0\nKs .9\nillum ") + model + "\n";
    const Material a = read_with_material("a", mtl).materials[1];
    EXPECT_TRUE(a.is_mirror);
    EXPECT_EQ(a.specular, glm::dvec3(.9));
  }
  EXPECT_FALSE(read_with_material("a", "newmtl a\nKd 0\nillum 3\n").materials[1].is_mirror) << "Ks is 0";
}

TEST(Materials, AreMattWithoutAnIlluminationModelThatSaysOtherwise) {
  for (const char* illum : {"", "illum 0\n", "illum 1\n"}) {
    const std::string mtl = std::string("newmtl a\nKd .5\nKs 7 x\nNs -3\n") + illum;
    const Material a = read_with_material("a", mtl).materials[1];
    EXPECT_EQ(a.specular, glm::dvec3(0.0));
    EXPECT_EQ(a.exponent, 0);
    EXPECT_FALSE(a.is_mirror);
  }
}

TEST(Materials, SpecularStatementsOutOfRangeAreRefusedWhereTheyAreUsed) {
  EXPECT_THAT(error_with("newmtl a\nKd .5\nillum 2\nKs .1 1.5 0\n"),
              StartsWith("m.mtl:6:7: error: Ks is '1.5'; give 0 to 1"));
  EXPECT_THAT(error_with("newmtl a\nKd .5\nillum 2\nNs 1001\n"),
              StartsWith("m.mtl:6:4: error: Ns is '1001'; give 0 to 1000"));
  EXPECT_THAT(error_with("newmtl a\nKd .5\nillum 99\n"), StartsWith("m.mtl:5:7: error: illum is '99'"));
  EXPECT_THAT(error_with("newmtl a\nKd .5\nillum 2\nKs 1 2\n"), HasSubstr("Ks has 2 numbers"));
  EXPECT_THAT(error_with("newmtl a\nKd .5\nillum 2\nNs nan\n"), HasSubstr("give 0 to 1000"));
}

TEST(Materials, TheLaterDefinitionWinsWithAWarning) {
  const Model model = read_with_material("a", "newmtl a\nKd .1 .1 .1\nKe 3 3 3\nnewmtl a\nKd .2 .2 .2\n");
  EXPECT_EQ(model.materials[1].reflectance, glm::dvec3(0.2));
  EXPECT_EQ(model.materials[1].emission, glm::dvec3(0.0));
  EXPECT_THAT(model.warnings,
              ElementsAre(StartsWith("m.mtl:6:1: warning: the material 'a' is defined again")));
}

TEST(Materials, ReflectanceOfOneOrMoreNamesTheOptionThatClamps) {
  EXPECT_EQ(
      error_with("newmtl a\nKd 0.5 1 0.5\n"),
      "m.mtl:4:8: error: the material 'a' has Kd '1', but a surface reflects less than it receives (Kd < 1); "
      "lower it or clamp it with --max-reflectance 0.95");
  EXPECT_THAT(error_with("newmtl a\nKd 1e9\n"), StartsWith("m.mtl:4:4: error: "));
}

TEST(Materials, MaxReflectanceClampsWithOneWarning) {
  ReadOptions options;
  options.max_reflectance = 0.95;
  const Model model = read_with_material("a", "newmtl a\nKd 1 0.96 0.5\n", options);
  EXPECT_EQ(model.materials[1].reflectance, glm::dvec3(0.95, 0.95, 0.5));
  EXPECT_THAT(model.warnings, ElementsAre(StartsWith("m.mtl:4:4: warning: Kd is clamped")));
}

TEST(Materials, NegativeValuesAreRefused) {
  EXPECT_EQ(error_with("newmtl a\nKd 0 0 -0.1\n"),
            "m.mtl:4:8: error: the material 'a' has Kd '-0.1', below 0; give 0 to below 1");
  EXPECT_EQ(error_with("newmtl a\nKd 0\nKe -1 0 0\n"),
            "m.mtl:5:4: error: the material 'a' has Ke '-1', below 0; give 0 or more");
}

TEST(Materials, NanAndInfiniteValuesAreRefused) {
  for (const char* token : {"nan", "-inf", "1e999"}) {
    EXPECT_THAT(error_with(std::string("newmtl a\nKd 0 ") + token + " 0\n"),
                StartsWith("m.mtl:4:6: error: "));
    EXPECT_THAT(error_with(std::string("newmtl a\nKe 0 ") + token + " 0\n"),
                StartsWith("m.mtl:4:6: error: "));
  }
  ReadOptions options;
  options.max_reflectance = 0.9;
  EXPECT_THAT(error_of([&] { read_with_material("a", "newmtl a\nKd inf\n", options); }),
              HasSubstr("no finite number"));
  EXPECT_THAT(error_with("newmtl a\nKe 1e31\n"), HasSubstr("above 1e30"));
}

TEST(Materials, SpectralAndXyzColoursAreRefused) {
  EXPECT_EQ(error_with("newmtl a\nKd spectral white.rfl 1\n"),
            "m.mtl:4:4: error: 'spectral' colours are not supported; give red green blue");
  EXPECT_THAT(error_with("newmtl a\nKd xyz 0.1 0.2 0.3\n"), StartsWith("m.mtl:4:4: error: 'xyz' colours"));
}

TEST(Materials, ThoseWithoutFacesMayHoldAnyNumbers) {
  const Model model =
      read(lit_square(), {{"m.mtl", std::string(kLamp) + "newmtl a\nKd 2 -1 nan\nKe -1 inf 0\nmap_Kd t.png\n"
                                                         "newmtl b\nKd spectral x.rfl\n"}});
  EXPECT_EQ(model.materials.size(), 1U);
  EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(Materials, MalformedTextIsRefusedUsedOrNot) {
  const auto error_of_unused = [](const std::string& mtl) {
    return error_of([&] { read(lit_square(), {{"m.mtl", kLamp + mtl}}); });
  };
  EXPECT_EQ(error_of_unused("newmtl a\nKd 0.5 red 0\n"),
            "m.mtl:4:8: error: 'red' is not a number; write a decimal number");
  EXPECT_EQ(error_of_unused("newmtl a\nKe 1 2\n"),
            "m.mtl:4:1: error: Ke has 2 numbers; give three (red green blue) or one");
  EXPECT_THAT(error_of_unused("newmtl a\nKd\n"), HasSubstr("Kd has 0 numbers"));
  EXPECT_EQ(error_of_unused("newmtl # a\n"), "m.mtl:3:1: error: newmtl has no name; name the material");
  EXPECT_EQ(error_of([] {
              read(lit_square(), {{"m.mtl", "Kd 0 0 0\n"}});
            }),
            "m.mtl:1:1: error: Kd stands before the first newmtl; put it below one");
}

TEST(Materials, WellKnownStatementsAreSkippedSilentlyAndOthersWithOneWarningEach) {
  const Model model =
      read_with_material("a",
                         "newmtl a\nNs 10\nNi 1.5\nd 1\nTr 0\nillum 2\nKs 1 1 1\nKa 1 1 1\nTf 1 1 1\n"
                         "map_Ks -s 1 1 1 x.png\nmap_Bump b.png\nbump b.png\nKd 0.5\n"
                         "glow 1\nglow 2\n");
  EXPECT_THAT(model.warnings, ElementsAre(StartsWith("m.mtl:16:1: warning: the MTL statement 'glow'")));
}

TEST(Materials, TexturesGiveOneWarningAFile) {
  const Model model = read_with_material("a", "newmtl a\nKd 0.5\nmap_Kd a.png\nmap_Kd b.png\nmap_Ke c.png\n");
  EXPECT_THAT(model.warnings, ElementsAre(StartsWith("m.mtl:6:1: warning: textures (map_Kd) are not used"),
                                          StartsWith("m.mtl:7:1: warning: textures (map_Ke) are not used")));
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
// Bad OBJ files, each with its line. MTL files: mtl_reader_test.cpp.
#include <gmock/gmock.h>

#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>

#include "host_sim/io/obj_reader.h"
#include "tests/io/read_helpers.h"

namespace fixrad::host {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string error_after_square(const std::string& more) {
  return error_of([&] { read(lit_square(more)); });
}

std::string error_of_text(const std::string& text) {
  return error_of([&] { read(text); });
}

TEST(ObjReaderRefuses, AMissingFile) {
  EXPECT_EQ(error_of([] { read_obj("no/such.obj"); }),
            "no/such.obj: error: there is no such file; check the path");
}

TEST(ObjReaderRefuses, AFolder) {
  const std::string folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(error_of([&] { read_obj(folder); }),
            folder + ": error: is a folder, not a file; name a file in it");
}

TEST(ObjReaderRefuses, AnEmptyFile) {
  EXPECT_EQ(error_of_text(""), "s.obj: error: the file is empty; export the scene again");
  EXPECT_THAT(error_of_text("\xEF\xBB\xBF"), HasSubstr("the file is empty"));
}

TEST(ObjReaderRefuses, AFileWithoutFaces) {
  EXPECT_THAT(error_of_text("v 0 0 0\n"), StartsWith("s.obj: error: the file has no faces (f);"));
  EXPECT_THAT(error_of_text("\n# nothing\n"), HasSubstr("has no faces"));
}

TEST(ObjReaderRefuses, BinaryRubbish) {
  EXPECT_THAT(error_of_text(std::string("v 0 0\0 0\n", 9)),
              HasSubstr("s.obj: error: is not a text OBJ file"));
  EXPECT_THAT(error_of_text("\x7F"
                            "ELF\x02\x01"),
              StartsWith("s.obj:1:1: error: is not a text OBJ file"));
  EXPECT_THAT(error_of_text(std::string("glTF\2\0\0\0", 8)),
              HasSubstr("binary glTF (.glb); export the scene"));
  EXPECT_THAT(error_of_text(std::string("\xFF\xFEv\0", 4)), HasSubstr("UTF-16; save it as UTF-8"));
}

TEST(ObjReaderRefuses, FacesWithTooFewCorners) {
  EXPECT_EQ(error_after_square("f 1 2\n"),
            "s.obj:8:1: error: the face has 2 corners; give it 3 or more, or delete it");
  EXPECT_THAT(error_after_square("\n  f 1\n"), StartsWith("s.obj:9:3: error: the face has 1 corner;"));
  EXPECT_THAT(error_after_square("f\n"), StartsWith("s.obj:8:1: error: the face has 0 corners;"));
  EXPECT_THAT(error_after_square("f # 1 2 3\n"), HasSubstr("has 0 corners"));
}

TEST(ObjReaderRefuses, FacesWithTooManyCorners) {
  std::string face = "f";
  for (int i = 0; i < 10001; ++i) {
    face += " 1";
  }
  EXPECT_THAT(error_after_square(face), HasSubstr("more than 1000 corners; split it"));
}

TEST(ObjReaderRefuses, ARepeatedCorner) {
  EXPECT_EQ(error_after_square("f 1 2 3 2\n"),
            "s.obj:8:9: error: the face has vertex 2 twice; delete the repeated corner or the face");
  EXPECT_THAT(error_after_square("f 1 2 -4\n"), StartsWith("s.obj:8:7: error: the face has vertex 1 twice"));
}

TEST(ObjReaderRefuses, IndicesWithoutVertex) {
  EXPECT_EQ(error_after_square("f 1 2 5\n"),
            "s.obj:8:7: error: there is no vertex '5'; the file has 4 vertices, correct the index");
  EXPECT_EQ(error_after_square("f 1 -5 2\nv 0 0 9\n"),
            "s.obj:8:5: error: there is no vertex '-5'; the file has 4 vertices above this line, correct the "
            "index");
  EXPECT_EQ(error_after_square("f 0 1 2\n"),
            "s.obj:8:3: error: a corner has vertex 0; vertices count from 1");
  EXPECT_THAT(error_after_square("f 1 2 99999999999999999999999\n"),
              HasSubstr("s.obj:8:7: error: there is no vertex"));
  EXPECT_THAT(error_after_square("f 1 2 -9223372036854775808\n"),
              HasSubstr("s.obj:8:7: error: there is no vertex"));
}

TEST(ObjReaderRefuses, CornersThatAreNoIntegers) {
  for (const char* corner :
       {"x", "3.0", "/1", "3/x", "3/1/x", "3/1/1/1", "3//1/", "--3", "+-3", "0x3", "//"}) {
    EXPECT_THAT(error_after_square(std::string("f 1 2 ") + corner + "\n"),
                AllOf(StartsWith("s.obj:8:7: error: '"), HasSubstr("is not a corner")))
        << corner;
  }
}

TEST(ObjReaderRefuses, CoordinatesThatAreNoNumbers) {
  for (const char* token : {"x", "1.0.0", "1,5", "0x10", "1e", "-", "+", "1.#QNAN", "--1", "+-1", "1f"}) {
    EXPECT_THAT(error_after_square(std::string("v 0 ") + token + " 0\n"),
                AllOf(StartsWith("s.obj:8:5: error: '"), HasSubstr("is not a number")))
        << token;
  }
  EXPECT_THAT(error_after_square("v 0,5 0 0\n"), HasSubstr("write a decimal point, not a comma"));
}

TEST(ObjReaderRefuses, NanAndInfiniteCoordinates) {
  for (const char* token : {"nan", "NaN", "-nan", "inf", "-Infinity", "1e999", "-1e400"}) {
    EXPECT_THAT(error_after_square(std::string("v 0 0 ") + token + "\n"),
                AllOf(StartsWith("s.obj:8:7: error: the coordinate '"), HasSubstr("is not a finite number")))
        << token;
  }
  EXPECT_THAT(error_after_square("v 1e31 0 0\n"), HasSubstr("is beyond 1e30; scale the scene down"));
}

TEST(ObjReaderRefuses, VerticesWithTooFewCoordinates) {
  EXPECT_EQ(error_after_square("v 1 2\n"), "s.obj:8:1: error: the vertex has 2 numbers; give x y z");
  EXPECT_THAT(error_after_square("v\n"), HasSubstr("has 0 numbers"));
  EXPECT_THAT(error_after_square("v 1 2 3 4 5\n"), HasSubstr("has 5 numbers"));
}

TEST(ObjErrors, OnlyTheFirstIsReported) {
  EXPECT_THAT(error_after_square("f 1 2\nv nan 0 0\nf 1 2 9\n"),
              AllOf(StartsWith("s.obj:8:1:"), Not(HasSubstr("\n"))));
}

TEST(ObjErrors, ColumnsCountCharactersAndContinuedLinesKeepTheirNumber) {
  EXPECT_THAT(error_after_square("f 1 2 \\\n  9\n"), StartsWith("s.obj:9:3:"));
  EXPECT_THAT(error_after_square("usemtl \xC3\xBC\xC3\xBC \r\nf 1 2 3"), StartsWith("s.obj:8:8:"));
  EXPECT_THAT(error_of_text("\xEF\xBB\xBFv x 0 0\n"), StartsWith("s.obj:1:3:"));
}

TEST(ObjErrors, MessagesNeverEchoControlCharactersOrLongTokens) {
  const std::string message = error_after_square("v \x1B[31m" + std::string(500, 'x') + " 0 0\n");
  EXPECT_THAT(message, AllOf(HasSubstr("'?[31mxxx"), HasSubstr("...'"), Not(HasSubstr("\x1B"))));
  EXPECT_LT(message.size(), 200U);
}

TEST(ObjReaderRefuses, ASceneWhereNothingEmitsLight) {
  const std::string dark = std::string("mtllib m.mtl\n") + kSquare + "usemtl white\nf 1 2 3 4\n";
  EXPECT_THAT(error_of_text(dark),
              StartsWith("s.obj: error: nothing emits light: no face uses the material 'lamp'"));
  EXPECT_EQ(error_of([&] {
              read(dark, {{"m.mtl", "newmtl white\nKd 1e-9 0 0\n"}});
            }),
            "s.obj: error: nothing emits light; give a material that faces use a Ke above 0");
}

TEST(ObjReaderRefuses, LinesAboveOneMebibyte) {
  EXPECT_EQ(error_after_square("g " + std::string(1U << 20U, 'x') + "\n"),
            "s.obj:8:1: error: the line is longer than 1 MiB; split it");
}

TEST(ObjReaderRefuses, ReflectanceLimitsOutsideTheirRange) {
  for (const double limit : {1.0, -0.1, std::numeric_limits<double>::quiet_NaN()}) {
    ReadOptions options;
    options.max_reflectance = limit;
    EXPECT_THROW(read(lit_square(), {{"m.mtl", kWhiteAndLamp}}, options), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fixrad::host

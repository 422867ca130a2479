// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "host_sim/report/text.h"
#include "host_sim/report/writers.h"
#include "tests/report/sample_mesh.h"
#include "tests/report/scratch_folder.h"

namespace fixrad::host {
namespace {

TEST(CsvField, QuotesAsRfc4180Says) {
  EXPECT_EQ(csv_field("white"), "white");
  EXPECT_EQ(csv_field("a b"), "a b");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
}

TEST(Csv, HasAHeaderAndARowForEachElement) {
  BakedMesh mesh = testing::square({0.1, 2.0, 1e-7});
  mesh.elements[0].input_face = 7;
  mesh.elements[0].material = "red, \"matt\"";
  const testing::ScratchFolder folder;
  write_csv(folder / "a.csv", mesh, {});
  EXPECT_EQ(testing::contents(folder / "a.csv"),
            "element,face,material,x,y,z,area,B_r,B_g,B_b\n"
            "0,7,\"red, \"\"matt\"\"\",0,0,0,4,0.1,2,1e-07\n");
}

}  // namespace
}  // namespace fixrad::host

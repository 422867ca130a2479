// SPDX-License-Identifier: MIT
// What holds for every writer.
#include "host_sim/report/writers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <stdexcept>

#include "host_sim/io/model.h"
#include "tests/report/sample_mesh.h"
#include "tests/report/scratch_folder.h"

namespace fixrad::host {
namespace {

TEST(Writers, LeaveNothingBehindWhereTheFolderDoesNotExist) {
  const testing::ScratchFolder folder;
  const BakedMesh mesh = testing::square({1, 1, 1});
  const std::filesystem::path target = folder / "missing" / "a";
  using Write = void (*)(const std::filesystem::path&, const BakedMesh&, const Display&);
  const Write write_picture = [](const std::filesystem::path& path, const BakedMesh& m, const Display& d) {
    write_png(path, m, d, {8, 8, {}});
  };
  for (const Write write :
       {Write{write_csv}, Write{write_ply}, Write{write_glb}, Write{write_hpp}, write_picture}) {
    try {
      write(target, mesh, {});
      ADD_FAILURE() << "no error for a missing folder";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::StartsWith(target.string() + ": error: "));
      EXPECT_THAT(error.what(), ::testing::HasSubstr("; create it"));
    }
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

TEST(Writers, RefuseAMeshWithoutTrianglesAndOneWithNotANumber) {
  const testing::ScratchFolder folder;
  EXPECT_THROW(write_ply(folder / "a.ply", BakedMesh{}, {}), std::invalid_argument);
  BakedMesh mesh = testing::square({1, 1, 1});
  mesh.radiosity[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write_glb(folder / "a.glb", mesh, {}), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

TEST(Writers, RefuseANormalThatIsNotAUnitVector) {
  const testing::ScratchFolder folder;
  BakedMesh mesh = testing::square({1, 1, 1});
  mesh.normals[0] = {0, 0, 0};
  EXPECT_THROW(write_glb(folder / "a.glb", mesh, {}), std::invalid_argument);
}

TEST(Writers, WriteTheSameBytesAgain) {
  const testing::ScratchFolder folder;
  const BakedMesh mesh = testing::open_room();
  write_glb(folder / "a.glb", mesh, {});
  write_glb(folder / "b.glb", mesh, {});
  EXPECT_EQ(testing::contents(folder / "a.glb"), testing::contents(folder / "b.glb"));
  write_png(folder / "a.png", mesh, {}, {64, 48, {}});
  write_png(folder / "b.png", mesh, {}, {64, 48, {}});
  EXPECT_EQ(testing::contents(folder / "a.png"), testing::contents(folder / "b.png"));
}

}  // namespace
}  // namespace fixrad::host

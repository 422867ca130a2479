// SPDX-License-Identifier: MIT
#include "host_sim/io/atomic_file.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "host_sim/io/model.h"
#include "host_sim/io/text_file.h"
#include "tests/io/read_helpers.h"

namespace fixrad::host {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

void put(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// A folder of its own for every test, since tests run side by side.
class AtomicFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("fixrad-" + std::to_string(::getpid()) + "-" + test->name());
    fs::create_directories(folder_);
    target_ = folder_ / "out.glb";
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
  fs::path target_;
};

TEST_F(AtomicFile, ReplacesTheTargetAndLeavesNothingElse) {
  put(target_, "old");
  write_atomically(target_, [&](const fs::path& temporary) {
    EXPECT_EQ(temporary.parent_path(), folder_);
    EXPECT_EQ(temporary.extension(), ".glb");
    put(temporary, "new");
    EXPECT_EQ(read_text_file(target_.string()), "old");
  });
  EXPECT_EQ(read_text_file(target_.string()), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, KeepsTheOldFileWhenWritingFails) {
  put(target_, "old");
  const std::string message = error_of([&] {
    write_atomically(target_, [](const fs::path& temporary) {
      put(temporary, "half");
      throw std::runtime_error("the disk is full");
    });
  });
  EXPECT_THAT(message, StartsWith(target_.string() + ": error: cannot write the file: the disk is full; "));
  EXPECT_EQ(read_text_file(target_.string()), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, CleansUpAndPassesOnWhatIsNoStandardException) {
  EXPECT_THROW(write_atomically(target_,
                                [](const fs::path& temporary) {
                                  put(temporary, "half");
                                  throw 1;
                                }),
               int);
  EXPECT_EQ(files(), 0);
}

TEST_F(AtomicFile, PassesOnInputErrorsAsTheyAre) {
  EXPECT_EQ(
      error_of([&] { write_atomically(target_, [](const fs::path&) { throw InputError("x: error: y"); }); }),
      "x: error: y");
}

TEST_F(AtomicFile, RefusesAWriterThatLeavesNoFile) {
  EXPECT_THAT(error_of([&] { write_atomically(target_, [](const fs::path&) {}); }),
              HasSubstr("cannot write the file: "));
  EXPECT_FALSE(fs::exists(target_));
}

TEST_F(AtomicFile, RefusesFoldersDevicesAndMissingFoldersWithoutCallingTheWriter) {
  for (const fs::path& target :
       {folder_, fs::path("/dev/null"), folder_ / "gone" / "out.glb", fs::path("")}) {
    bool called = false;
    EXPECT_THAT(error_of([&] { write_atomically(target, [&](const fs::path&) { called = true; }); }),
                AllOf(HasSubstr(": error: cannot write the file: "), HasSubstr("; ")))
        << target;
    EXPECT_FALSE(called);
  }
}

TEST_F(AtomicFile, FollowsASymbolicLink) {
  const fs::path link = folder_ / "link.glb";
  put(target_, "old");
  fs::create_symlink(target_.filename(), link);
  write_atomically(link, [](const fs::path& temporary) { put(temporary, "new"); });
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_text_file(target_.string()), "new");
}

}  // namespace
}  // namespace fixrad::host

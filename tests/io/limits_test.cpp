// SPDX-License-Identifier: MIT
// No file makes the reader take more than the memory and the seconds of docs/robustness.md. Each large one is
// read by a child of its own, whose largest resident memory the system tells.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "host_sim/io/limits.h"
#include "host_sim/io/text_file.h"
#include "tests/io/read_helpers.h"

namespace fixrad::host {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::size_t kHundredMegabytes = 100 * 1000 * 1000;
constexpr long kMostMemory = 200 * 1024;  // KiB beyond what the test itself holds
constexpr long kMostSeconds = 20;         // of the processor, a tenth of it without sanitizers

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
constexpr bool kIsSanitized = __has_feature(address_sanitizer);
#else
constexpr bool kIsSanitized = false;
#endif

constexpr std::size_t kLarge = kIsSanitized ? 2'000'000 : 20'000'000;

/// A folder of its own, gone at the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "fixrad_limits_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// `unit` again and again, up to `bytes`.
std::string filled(std::size_t bytes, const std::string& unit) {
  std::string text;
  text.reserve(bytes);
  while (text.size() + unit.size() <= bytes) {
    text += unit;
  }
  return text;
}

struct Outcome {
  bool has_ended;  // by itself
  long memory, seconds;
};

/// Reads a file in a child process.
Outcome read_apart(const std::string& path) {
  rusage before{};
  getrusage(RUSAGE_SELF, &before);
  const pid_t child = fork();
  if (child == 0) {
    try {
      read_obj(path);
    } catch (const InputError&) {
    }
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return {WIFEXITED(status) && WEXITSTATUS(status) == 0, usage.ru_maxrss - before.ru_maxrss,
          usage.ru_utime.tv_sec};
}

void expect_bounded(const Folder& folder, const std::string& text) {
  const std::string path = folder.file("large.obj", lit_square() + text);
  const Outcome outcome = read_apart(path);
  EXPECT_TRUE(outcome.has_ended);
  EXPECT_LT(outcome.seconds, kMostSeconds);
  EXPECT_LT(outcome.memory, kIsSanitized ? 4 * kMostMemory : kMostMemory);
}

TEST(Limits, AFileOf100MegabytesIsRefusedBeforeItIsRead) {
  const Folder folder;
  const std::string path = folder.file("large.obj", "");
  fs::resize_file(path, kHundredMegabytes);
  EXPECT_EQ(error_of([&] { read_obj(path); }), path + ": error: is larger than 64 MiB; reduce the scene");
}

TEST(Limits, MegabytesOfAnythingTakeLittleMemoryAndTime) {
  const Folder folder;
  folder.file("m.mtl", kWhiteAndLamp);
  const std::string words = "mtllib" + filled(kLarge, " a");
  for (const std::string& unit :
       {std::string("# nothing\n"), std::string("\n"), std::string("\\\n"), std::string("v 0 0 1\n"),
        std::string("f 1 2 3\n"), std::string("usemtl lamp\n"), std::string("mtllib m.mtl\n"),
        std::string("f 1 2 3 4 \\\n"), std::string(" 1"), words}) {
    SCOPED_TRACE(unit.substr(0, 20));
    expect_bounded(folder, unit.size() > 100 ? unit : filled(kLarge, unit));
  }
}

TEST(Limits, EachIsSaidWithItsLine) {
  const std::string square = lit_square();
  const auto error = [&](const std::string& more) { return error_of([&] { read(square + more); }); };
  EXPECT_THAT(error(filled(8 * (kMaxVertices + 1), "v 0 0 1\n")),
              StartsWith("s.obj:1048580:1: error: the file has more than 1048576 vertices;"));
  EXPECT_THAT(error(filled(8 * kMaxFaces, "f 1 2 3\n")),
              StartsWith("s.obj:131079:1: error: the file has more than 131072 faces;"));
  EXPECT_THAT(error("# " + std::string(kMaxStatementBytes, 'x')),
              StartsWith("s.obj:8:1: error: the line is longer than 1 MiB;"));
}

TEST(Limits, MaterialFilesLieInTheFolderOfTheObj) {
  const Files files = {{"../m.mtl", kWhiteAndLamp}, {"/m.mtl", kWhiteAndLamp}, {"sub/m.mtl", kWhiteAndLamp}};
  const auto error = [&](const std::string& name) {
    return error_of([&] { read("mtllib " + name + "\n" + kSquare + "usemtl lamp\nf 1 2 3 4\n", files); });
  };
  EXPECT_EQ(
      error("../m.mtl"),
      "s.obj:1:8: error: the material file '../m.mtl' lies outside the OBJ file's folder; copy it there and "
      "correct mtllib");
  EXPECT_THAT(error("/m.mtl"), HasSubstr("lies outside"));
  EXPECT_THAT(error("sub\\..\\..\\m.mtl"), HasSubstr("lies outside"));
  EXPECT_THAT(error("C:\\m.mtl"), HasSubstr("lies outside"));
  EXPECT_EQ(error("sub/m.mtl"), "");
  EXPECT_THAT(error("sub/../sub/n.mtl"), HasSubstr("there is no material file"));
}

TEST(Limits, ALinkToAMaterialFileElsewhereIsRefused) {
  const Folder folder, elsewhere;
  const std::string target = elsewhere.file("m.mtl", kWhiteAndLamp);
  const std::string path = folder.file("s.obj", lit_square());
  fs::create_symlink(target, folder.path() / "m.mtl");
  EXPECT_THAT(error_of([&] { read_obj(path); }), HasSubstr("lies outside the OBJ file's folder"));
  fs::remove(folder.path() / "m.mtl");
  folder.file("kept.mtl", kWhiteAndLamp);
  fs::create_symlink("kept.mtl", folder.path() / "m.mtl");
  EXPECT_EQ(error_of([&] { read_obj(path); }), "");
}

TEST(Limits, MaterialFilesAreFewAndSmall) {
  std::string many;
  Files files;
  for (std::size_t i = 0; i <= kMaxMtlFiles; ++i) {
    many += "mtllib " + std::to_string(i) + ".mtl\n";
    files.emplace(std::to_string(i) + ".mtl", kWhiteAndLamp);
  }
  EXPECT_THAT(error_of([&] { read(many + kSquare, files); }),
              StartsWith("s.obj:65:8: error: the scene has more than 64"));
  const Files large = {{"m.mtl", filled(kMaxMtlBytes + 9, "# 345678\n")}};
  EXPECT_THAT(error_of([&] { read(lit_square(), large); }), HasSubstr("or 4 MiB of them"));
  std::string missing = "mtllib";
  for (std::size_t i = 0; i < kMaxFileLookups; ++i) {
    missing += " m.mtl";
  }
  EXPECT_THAT(error_of([&] { read(missing + " gone\n"); }), HasSubstr("too many files"));
}

TEST(Limits, LightTooFaintForItsInverseIsRefused) {
  EXPECT_THAT(error_of([] { read_with_material("faint", "newmtl faint\nKe 4e-324 0 0\n"); }),
              HasSubstr("below 1e-30"));
  EXPECT_EQ(error_of([] { read_with_material("dark", "newmtl dark\nKe 1e-400 0 1e-30\n"); }), "");
}

TEST(Limits, ThePageListsThem) {
  const std::string page = read_text_file(FIXRAD_SOURCE_DIR "/docs/robustness.md");
  const auto expect_row = [&](const std::string& what, std::size_t limit) {
    EXPECT_THAT(page, HasSubstr("| " + what + " | " + std::to_string(limit) + " |"));
  };
  expect_row("bytes of the OBJ file", kMaxObjBytes);
  expect_row("bytes of all its MTL files", kMaxMtlBytes);
  expect_row("MTL files", kMaxMtlFiles);
  expect_row("questions to the file system about them", kMaxFileLookups);
  expect_row("bytes of a statement", kMaxStatementBytes);
  expect_row("characters of a number", kMaxNumberChars);
  expect_row("vertices of the file", kMaxVertices);
  expect_row("faces", kMaxFaces);
  expect_row("corners of a face", kMaxFaceCorners);
  expect_row("corners of all faces", kMaxFileCorners);
  expect_row("convex pieces of all faces", kMaxPieces);
  expect_row("materials defined", kMaxMaterials);
  expect_row("warnings", kMaxWarnings);
}

}  // namespace
}  // namespace fixrad::host

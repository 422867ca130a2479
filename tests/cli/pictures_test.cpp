// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <png.h>

#include <cstdlib>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

using ::testing::HasSubstr;

struct Png {
  unsigned width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

Png read_png(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Png result;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) {
    return result;
  }
  image.format = PNG_FORMAT_RGB;
  result.rgb.resize(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, result.rgb.data(), 0, nullptr);
  result.width = image.width;
  result.height = image.height;
  return result;
}

Png baked_png(const std::string& scene, std::vector<std::string> options, const char* profile = "tiny") {
  const ScratchFolder folder;
  const std::string file = folder / "picture.png";
  options.insert(options.begin(), {"bake", sample_scene(scene), "--profile", profile, "-o", file});
  const Outcome run = run_tool(options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return read_png(file);
}

double mean_difference(const Png& a, const Png& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size() && i < b.rgb.size(); ++i) {
    sum += std::abs(a.rgb[i] - b.rgb[i]);
  }
  return sum / static_cast<double>(a.rgb.size());
}

TEST(Pictures, HaveTheSizeThatIsAskedForWhateverTheyShow) {
  for (const char* show : {"vertex", "radiosity", "mesh", "error"}) {
    const Png png = baked_png("parallel_plates", {"--show", show, "--size", "96x80"});
    EXPECT_EQ(png.width, 96u) << show;
    EXPECT_EQ(png.height, 80u) << show;
  }
}

TEST(Pictures, OfTheDeviceAreCloseToTheAntiAliasedOnes) {
  for (const char* scene : {"cornell", "mirror_room"}) {
    const Png device = baked_png(scene, {"--renderer", "device", "--size", "400x300"}, "medium");
    const Png smooth = baked_png(scene, {"--size", "400x300"}, "medium");
    ASSERT_EQ(device.rgb.size(), smooth.rgb.size());
    EXPECT_LE(mean_difference(device, smooth), 1.0) << scene;
  }
}

TEST(Pictures, OfTheDeviceHaveTheDigestThatAFirmwareIsToReach) {
  const ScratchFolder folder;
  const std::string header = folder / "room.h";
  ASSERT_EQ(
      run_tool({"export", sample_scene("cornell"), "--profile", "tiny", "--size", "64x48", "-o", header})
          .exit_code,
      0);
  const Png png = baked_png("cornell", {"--renderer", "device", "--size", "64x48", "--display", "mean"});
  std::uint64_t digest = 14695981039346656037u;
  for (const std::uint8_t byte : png.rgb) {
    digest = (digest ^ byte) * 1099511628211u;
  }
  char expected[64];
  std::snprintf(expected, sizeof expected, "kPictureDigest = 0x%016llxull;",
                static_cast<unsigned long long>(digest));
  EXPECT_THAT(contents(header), HasSubstr(expected));
}

TEST(Pictures, FollowTheCamera) {
  // Straight at the red wall of the Cornell box.
  const Png png = baked_png("cornell", {"--camera", "0.28,0.27,0.2,0.56,0.27,0.2,40", "--size", "40x30"});
  const std::size_t middle = 3 * (15 * 40 + 20);
  EXPECT_GT(png.rgb[middle], 2 * png.rgb[middle + 1]);
}

TEST(Pictures, RefuseWhatCannotBeShown) {
  const std::vector<std::vector<std::string>> wrong = {{"--camera", "1,2,3"},
                                                       {"--camera", "1,2,3,1,2,3"},
                                                       {"--camera", "1,2,3,4,5,6,200"},
                                                       {"--size", "0x10"},
                                                       {"--size", "10"},
                                                       {"--size", "10.5x10"},
                                                       {"--show", "nothing"},
                                                       {"--renderer", "device", "--show", "mesh"}};
  const ScratchFolder folder;
  for (std::vector<std::string> options : wrong) {
    const std::string what = options.back();
    options.insert(options.begin(), {"bake", sample_scene("cornell"), "-o", folder / "x.png"});
    EXPECT_EQ(run_tool(options).exit_code, 2) << what;
  }
  EXPECT_THAT(names_in(folder / ""), ::testing::IsEmpty());
}

TEST(Frames, AreOneEachDoublingOfShotsTwiceAndTheFinishedOne) {
  const ScratchFolder folder;
  const std::string frames = folder / "frames", json = folder / "room.json", png = folder / "room.png";
  const Outcome run = run_tool({"bake", sample_scene("cornell"), "--profile", "tiny", "--size", "32x24",
                                "--frames", frames, "-o", json, "-o", png});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const unsigned shots = nlohmann::json::parse(contents(json))["shots"].get<unsigned>();
  std::vector<std::string> expected;
  for (unsigned n = 1; n < shots; n *= 2) {
    char name[16];
    std::snprintf(name, sizeof name, "%04u", n);
    expected.push_back(name + std::string(".png"));
    expected.push_back(name + std::string("_ambient.png"));
  }
  char last[16];
  std::snprintf(last, sizeof last, "%04u.png", shots);
  expected.insert(expected.end(), {last, "index.html"});
  EXPECT_THAT(names_in(frames), ::testing::UnorderedElementsAreArray(expected));
  EXPECT_EQ(read_png(frames + "/" + last).rgb, read_png(png).rgb) << "the finished solution";
  const std::string page = contents(frames + "/index.html");
  EXPECT_THAT(page, HasSubstr("128 shots"));
  EXPECT_THAT(page, HasSubstr("% unshot"));
}

TEST(Frames, GetBrighterShotByShotAndTheAmbientEstimateIsNearerToTheEnd) {
  const ScratchFolder folder;
  const std::string frames = folder / "frames";
  const Outcome run = run_tool({"bake", sample_scene("cornell"), "--profile", "tiny", "--no-overshoot",
                                "--size", "32x24", "--frames", frames});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::vector<std::string> names = names_in(frames);
  const Png end = read_png(frames + "/" + names[names.size() - 2]);
  double before = 1e9;
  for (const char* name : {"0001", "0004", "0016", "0064"}) {
    const double plain = mean_difference(read_png(frames + "/" + name + ".png"), end);
    const double ambient = mean_difference(read_png(frames + "/" + name + "_ambient.png"), end);
    EXPECT_LT(plain, before) << name;
    EXPECT_LT(ambient, plain) << name;
    before = plain;
  }
}

TEST(Frames, NeedAFolderAndASolverThatShoots) {
  const ScratchFolder folder;
  const Outcome nowhere =
      run_tool({"bake", sample_scene("closed_box"), "--frames", folder / "missing/frames"});
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_THAT(nowhere.err, HasSubstr("cannot make the folder of the frames"));
  const Outcome gathering =
      run_tool({"bake", sample_scene("closed_box"), "--solver", "gathering", "--frames", folder / "frames"});
  EXPECT_EQ(gathering.exit_code, 1);
  EXPECT_THAT(gathering.err, HasSubstr("leave out --solver gathering"));
}

}  // namespace
}  // namespace fixrad::host::testing

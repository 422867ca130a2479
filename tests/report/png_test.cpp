// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <png.h>

#include "host_sim/report/writers.h"
#include "tests/report/sample_mesh.h"
#include "tests/report/scratch_folder.h"

namespace fixrad::host {
namespace {

TEST(Png, HoldsThePixelsOfThePicture) {
  const BakedMesh mesh = testing::open_room();
  const PictureOptions options{60, 45, {}};
  const testing::ScratchFolder folder;
  write_png(folder / "a.png", mesh, {}, options);

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, (folder / "a.png").c_str()), 0) << png.message;
  png.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr), 0) << png.message;
  EXPECT_EQ(png.width, 60u);
  EXPECT_EQ(png.height, 45u);
  EXPECT_EQ(pixels, render_picture(mesh, {}, options).rgb);
}

}  // namespace
}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/report/mesh_picture.h"

#include <gtest/gtest.h>

#include "host_sim/report/error_map.h"
#include "host_sim/report/frame_page.h"
#include "host_sim/report/legend.h"
#include "host_sim/report/tone.h"
#include "tests/report/sample_mesh.h"

namespace fixrad::host {
namespace {

constexpr int kSide = 64;

Srgb8 pixel(const Image& image, int x, int y) {
  const auto at = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

PictureOptions from_front() {
  return {kSide, kSide, Camera{{0, 0, 5}, {0, 0, 0}, 53.13010235415598}};
}

// A square of two elements that meet at x = 0, which is the column between pixels 31 and 32.
struct TwoElements {
  BakedMesh mesh;
  ElementMesh elements;

  explicit TwoElements(const glm::dvec3& left = {1, 1, 1}, const glm::dvec3& right = {1, 1, 1}) {
    testing::add_quad(mesh, {-1, -1, 0}, {1, 0, 0}, {0, 2, 0}, left);
    testing::add_quad(mesh, {0, -1, 0}, {1, 0, 0}, {0, 2, 0}, right);
    for (const double x : {-1.0, 0.0}) {
      MeshElement element;
      element.polygon = {{x, -1, 0}, {x + 1, -1, 0}, {x + 1, 1, 0}, {x, 1, 0}};
      element.normal = {0, 0, 1};
      elements.elements.push_back(element);
    }
  }
};

TEST(MeshPicture, DrawsALineAPixelWideBetweenElements) {
  const TwoElements two;
  const Image plain = render_picture(two.mesh, {}, from_front());
  const Image meshed = render_mesh_picture(two.mesh, two.elements, {}, from_front());
  for (const int x : {31, 32}) {  // half of the line each
    EXPECT_LT(pixel(meshed, x, 32)[0], pixel(plain, x, 32)[0] - 20);
    EXPECT_GT(pixel(meshed, x, 32)[0], 20);
  }
  for (const int x : {25, 28, 30, 33, 36}) {
    EXPECT_EQ(pixel(meshed, x, 32), pixel(plain, x, 32)) << x;
  }
}

TEST(MeshPicture, HidesTheBordersOfHiddenElements) {
  TwoElements two;
  testing::add_quad(two.mesh, {-0.5, -0.5, 1}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1});
  MeshElement front;
  front.polygon = {{-0.5, -0.5, 1}, {0.5, -0.5, 1}, {0.5, 0.5, 1}, {-0.5, 0.5, 1}};
  front.normal = {0, 0, 1};
  two.elements.elements.push_back(front);
  const Image plain = render_picture(two.mesh, {}, from_front());
  const Image meshed = render_mesh_picture(two.mesh, two.elements, {}, from_front());
  EXPECT_EQ(pixel(meshed, 31, 32), pixel(plain, 31, 32));
  EXPECT_NE(pixel(meshed, 31, 21), pixel(plain, 31, 21)) << "beside the square in front";
}

TEST(MeshPicture, FlatElementsShowTheirOwnRadiosity) {
  const glm::dvec3 left(0.4, 0.2, 0.1), right(0.1, 0.2, 0.4);
  const TwoElements two(left, right);
  const BakedMesh flat = flat_mesh(two.mesh, two.elements);
  const Image image = render_picture(flat, {}, from_front());
  EXPECT_EQ(pixel(image, 25, 32), display_colour(left, exposure_scale(two.mesh, {})));
  EXPECT_EQ(pixel(image, 38, 32), display_colour(right, exposure_scale(two.mesh, {})));
}

TEST(Legend, StandsBelowThePictureWithTheColoursOfItsEnds) {
  Image picture{300, 20, {}};
  picture.rgb.assign(3 * 300 * 20, 77);
  const Image image = with_legend(picture, 0.05);
  ASSERT_EQ(image.height, 20 + kLegendHeight);
  ASSERT_EQ(image.rgb.size(), static_cast<std::size_t>(3 * image.width * image.height));
  EXPECT_EQ(pixel(image, 150, 19), (Srgb8{77, 77, 77}));
  const auto near = [&](const Srgb8& seen, const std::array<std::uint8_t, 3>& colour) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(seen[c], colour[c], 6);
    }
  };
  near(pixel(image, 60, 20 + 14), kErrorColours.front());
  near(pixel(image, 150, 20 + 14), kErrorColours[4]);
  near(pixel(image, 239, 20 + 14), kErrorColours.back());
}

TEST(FramePage, PairsEachFrameWithItsTwinAndEndsWithTheFinishedOne) {
  Image image{8, 4, {}};
  image.rgb.assign(3 * 8 * 4, 100);
  const std::string page = frame_page("a<b", {{"0001.png", 1, 0.9, false, image},
                                              {"0001_ambient.png", 1, 0.9, true, image},
                                              {"0003.png", 3, 0.0005, false, image}});
  const auto count = [&](const std::string& text) {
    int times = 0;
    for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) {
      ++times;
    }
    return times;
  };
  EXPECT_EQ(count("<figure>"), 2);
  EXPECT_EQ(count("href=\"0001.png\""), 1);
  EXPECT_EQ(count("href=\"0001_ambient.png\""), 1);
  EXPECT_EQ(count("href=\"0003.png\""), 2) << "it belongs to both rows";
  EXPECT_EQ(count("90 % unshot"), 1);
  EXPECT_EQ(count("a&lt;b"), 2);
  EXPECT_EQ(count("src=\"data:image/png;base64,"), 4);
}

TEST(FramePage, ThumbnailsAreMeansInLinearLight) {
  Image image{1024, 4, {}};
  for (int i = 0; i < 1024 * 4; ++i) {
    image.rgb.insert(image.rgb.end(), 3, i % 2 == 0 ? std::uint8_t{255} : std::uint8_t{0});
  }
  const Image small = thumbnail(image);
  EXPECT_EQ(small.width, 256);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(pixel(small, 100, 0), srgb8(glm::dvec3(0.5)));
}

}  // namespace
}  // namespace fixrad::host

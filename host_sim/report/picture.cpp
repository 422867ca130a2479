// SPDX-License-Identifier: MIT
#include "host_sim/report/picture.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "host_sim/report/automatic_camera.h"
#include "host_sim/report/mesh_check.h"
#include "host_sim/report/overlay.h"
#include "host_sim/report/rasterizer.h"
#include "host_sim/report/tone.h"
#include "host_sim/report/view_dependent.h"

namespace fixrad::host {
namespace {

constexpr int kSamplesPerSide = kPictureSamples;
constexpr int kLargestSide = 16384;
/// Picture rows that are drawn at a time, which bounds the memory for samples.
constexpr int kBandRows = 16;

/// Mean of the tone-mapped samples of the pixel (x, y), y counted within the band.
glm::dvec3 average(const SampleBand& band, const Overlay* overlay, int x, int y, double scale) {
  glm::dvec3 sum(0.0);
  for (int row = 0; row < kSamplesPerSide; ++row) {
    for (int column = 0; column < kSamplesPerSide; ++column) {
      const auto line = static_cast<std::size_t>(y * kSamplesPerSide + row);
      const std::size_t at = line * static_cast<std::size_t>(band.width) +
                             static_cast<std::size_t>(x * kSamplesPerSide + column);
      const glm::dvec3 colour =
          band.inverse_distance[at] > 0.0 ? tone(band.radiosity[at] * scale) : glm::dvec3(kBackground);
      sum += overlay != nullptr ? overlay->over(colour, at) : colour;
    }
  }
  return sum / static_cast<double>(kSamplesPerSide * kSamplesPerSide);
}

void resolve(const SampleBand& band, const Overlay* overlay, double scale, Image& image) {
  for (int y = 0; y < band.rows / kSamplesPerSide; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Srgb8 colour = srgb8(average(band, overlay, x, y, scale));
      image.rgb.insert(image.rgb.end(), colour.begin(), colour.end());
    }
  }
}

}  // namespace

Image render_picture(const BakedMesh& mesh, const Display& display, const PictureOptions& options) {
  return render_overlaid(mesh, display, options, nullptr);
}

Image render_overlaid(const BakedMesh& mesh, const Display& display, const PictureOptions& options,
                      Overlay* overlay) {
  check_mesh(mesh);
  const auto in_range = [](int side) { return side >= 1 && side <= kLargestSide; };
  if (!in_range(options.width) || !in_range(options.height)) {
    throw std::invalid_argument("picture: width and height must be 1 to 16384 pixels");
  }
  const double aspect = static_cast<double>(options.width) / options.height;
  const Camera camera = options.camera ? *options.camera : automatic_camera(mesh, display.z_up, aspect);
  const Projection projection(camera, display.z_up, options.width * kSamplesPerSide,
                              options.height * kSamplesPerSide);
  const double scale = exposure_scale(mesh, display);
  const double nearest = near_distance(mesh);
  std::vector<std::uint32_t> sources;
  const std::vector<ScreenTriangle> triangles = visible_triangles(mesh, projection, nearest, &sources);
  if (overlay != nullptr) {
    overlay->start_picture(projection, nearest, scale);
  }
  const ViewDependent extras(mesh, projection, nearest, glm::dvec3(kBackground / scale));
  Image image{options.width, options.height, {}};
  SampleBand band;
  for (int y = 0; y < options.height; y += kBandRows) {
    const int rows = std::min(kBandRows, options.height - y);
    band.clear(options.width * kSamplesPerSide, y * kSamplesPerSide, rows * kSamplesPerSide);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      draw(triangles[i], band, sources[i]);
    }
    extras.add(band);
    if (overlay != nullptr) {
      overlay->start_band(band);
    }
    resolve(band, overlay, scale, image);
  }
  return image;
}

}  // namespace fixrad::host

// SPDX-License-Identifier: MIT
#include "host_sim/report/error_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "host_sim/io/model.h"
#include "host_sim/report/rasterizer.h"

namespace fixrad::host {
namespace {

constexpr std::array<double, 3> kNothingSeen = {40, 40, 44};

SampleBand draw_all(const BakedMesh& mesh, bool z_up, const PictureOptions& picture) {
  if (!picture.camera) {
    throw std::invalid_argument("error map: a camera is needed");
  }
  const int width = picture.width * kErrorSamples, height = picture.height * kErrorSamples;
  const Projection projection(*picture.camera, z_up, width, height);
  SampleBand band;
  band.clear(width, 0, height);
  for (const ScreenTriangle& triangle : visible_triangles(mesh, projection, near_distance(mesh))) {
    draw(triangle, band);
  }
  return band;
}

// `error(i)` at each sample that both bands see.
template <typename Error>
ErrorMap map_of(const PictureOptions& picture, const SampleBand& a, const SampleBand& b, const Error& error) {
  ErrorMap map{picture.width, picture.height, {}};
  map.errors.reserve(a.radiosity.size());
  for (std::size_t i = 0; i < a.radiosity.size(); ++i) {
    const bool seen = a.inverse_distance[i] > 0 && b.inverse_distance[i] > 0;
    map.errors.push_back(seen ? error(i) : std::numeric_limits<double>::quiet_NaN());
  }
  return map;
}

std::array<double, 3> colour_of(double error, double limit) {
  if (std::isnan(error)) {
    return kNothingSeen;
  }
  constexpr double kSteps = kErrorColours.size() - 1;
  const double at = (std::clamp(error / limit, -1.0, 1.0) + 1) / 2 * kSteps;
  const auto below = static_cast<std::size_t>(std::min(at, kSteps - 1));
  std::array<double, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double a = kErrorColours[below][c], b = kErrorColours[below + 1][c];
    colour[c] = a + (at - static_cast<double>(below)) * (b - a);
  }
  return colour;
}

}  // namespace

ErrorMap point_errors(const BakedMesh& baked, const BakedMesh& reference, double floor, bool z_up,
                      const PictureOptions& picture) {
  const SampleBand a = draw_all(baked, z_up, picture), b = draw_all(reference, z_up, picture);
  return map_of(picture, a, b, [&](std::size_t i) {
    const double right = channel_sum(b.radiosity[i]);
    return (channel_sum(a.radiosity[i]) - right) / std::max(right, floor);
  });
}

ErrorMap polygon_errors(const std::vector<ErrorPolygon>& polygons, bool z_up, const PictureOptions& picture) {
  BakedMesh mesh;
  for (const ErrorPolygon& polygon : polygons) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), polygon.corners.begin(), polygon.corners.end());
    mesh.radiosity.insert(mesh.radiosity.end(), polygon.corners.size(), glm::dvec3(polygon.error, 0, 0));
    for (std::uint32_t k = 2; k < polygon.corners.size(); ++k) {
      mesh.triangles.push_back({first, first + k - 1, first + k});
    }
  }
  const SampleBand band = draw_all(mesh, z_up, picture);
  return map_of(picture, band, band, [&](std::size_t i) { return band.radiosity[i].x; });
}

double error_quantile(const ErrorMap& map, double part) {
  std::vector<double> magnitudes;
  for (const double error : map.errors) {
    if (!std::isnan(error)) {
      magnitudes.push_back(std::abs(error));
    }
  }
  if (magnitudes.empty()) {
    return 0;
  }
  const auto at = static_cast<std::size_t>(part * static_cast<double>(magnitudes.size() - 1));
  std::nth_element(magnitudes.begin(), magnitudes.begin() + static_cast<std::ptrdiff_t>(at),
                   magnitudes.end());
  return magnitudes[at];
}

double nice_limit(double value) {
  double decade = 0.001;
  while (decade * 10 <= value) {
    decade *= 10;
  }
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= value) {
      return factor * decade;
    }
  }
  return 10 * decade;
}

Image false_colours(const ErrorMap& map, double limit) {
  Image image{map.width, map.height, {}};
  const auto line = static_cast<std::size_t>(map.width * kErrorSamples);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      std::array<double, 3> mean{};
      for (int k = 0; k < kErrorSamples * kErrorSamples; ++k) {
        const auto row = static_cast<std::size_t>(y * kErrorSamples + k / kErrorSamples);
        const auto column = static_cast<std::size_t>(x * kErrorSamples + k % kErrorSamples);
        const std::array<double, 3> colour = colour_of(map.errors[row * line + column], limit);
        for (std::size_t c = 0; c < 3; ++c) {
          mean[c] += colour[c] / (kErrorSamples * kErrorSamples);
        }
      }
      for (const double channel : mean) {
        image.rgb.push_back(static_cast<std::uint8_t>(std::lround(channel)));
      }
    }
  }
  return image;
}

}  // namespace fixrad::host

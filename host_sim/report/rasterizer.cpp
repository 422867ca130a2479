// SPDX-License-Identifier: MIT
#include "host_sim/report/rasterizer.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace fixrad::host {
namespace {

struct CameraVertex {
  glm::dvec3 position;  ///< camera axes, z the distance along the view
  glm::dvec3 radiosity;
};
using CameraPolygon = std::vector<CameraVertex>;

/// Sutherland and Hodgman, against the one plane z = near.
CameraPolygon clip_near(const CameraPolygon& polygon, double near_distance) {
  CameraPolygon clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const CameraVertex& a = polygon[i];
    const CameraVertex& b = polygon[(i + 1) % polygon.size()];
    const double da = a.position.z - near_distance;
    const double db = b.position.z - near_distance;
    if (da >= 0.0) {
      clipped.push_back(a);
    }
    if ((da >= 0.0) != (db >= 0.0)) {
      const double t = da / (da - db);
      clipped.push_back(
          {a.position + t * (b.position - a.position), a.radiosity + t * (b.radiosity - a.radiosity)});
    }
  }
  return clipped;
}

ScreenVertex to_screen(const CameraVertex& vertex, const Projection& projection) {
  const double inverse = 1.0 / vertex.position.z;
  return {projection.to_pixels(vertex.position), inverse, vertex.radiosity * inverse};
}

/// The camera axes are left-handed (z runs away from the eye), hence the sign.
bool faces_camera(const CameraPolygon& triangle) {
  return glm::dot(triangle[0].position, glm::cross(triangle[1].position, triangle[2].position)) > 0.0;
}

/// The edge function of a -> b, positive on one side. Both triangles at an edge compute it from the same end,
/// so their values are exact negatives and no sample between them is lost to rounding.
class Edge {
 public:
  Edge(const glm::dvec2& a, const glm::dvec2& b) {
    const bool swap = b.x < a.x || (b.x == a.x && b.y < a.y);
    const glm::dvec2& start = swap ? b : a;
    const glm::dvec2& end = swap ? a : b;
    sign_ = swap ? -1.0 : 1.0;
    start_ = start;
    along_ = end - start;
  }
  double operator()(const glm::dvec2& p) const {
    return sign_ * (along_.x * (p.y - start_.y) - along_.y * (p.x - start_.x));
  }

 private:
  glm::dvec2 start_{0.0};
  glm::dvec2 along_{0.0};
  double sign_ = 1.0;
};

/// First and one past the last of the samples 0 .. count - 1 whose centres lie in [low, high].
std::pair<int, int> sample_range(double low, double high, int count) {
  const double first = std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(count));
  const double last = std::clamp(std::floor(high - 0.5) + 1.0, 0.0, static_cast<double>(count));
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace

double near_distance(const BakedMesh& mesh) {
  constexpr double kNearShare = 1e-5;
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (const glm::dvec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return std::max(kNearShare * glm::length(high - low), std::numeric_limits<double>::min());
}

std::vector<ScreenTriangle> visible_triangles(const BakedMesh& mesh, const Projection& projection,
                                              double near_distance, std::vector<std::uint32_t>* sources) {
  std::vector<ScreenTriangle> result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    CameraPolygon polygon;
    for (const std::uint32_t corner : triangle) {
      polygon.push_back({projection.to_camera(mesh.positions[corner]), mesh.radiosity[corner]});
    }
    if (faces_camera(polygon) == projection.is_mirrored()) {
      continue;
    }
    polygon = clip_near(polygon, near_distance);
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      result.push_back({to_screen(polygon[0], projection), to_screen(polygon[i - 1], projection),
                        to_screen(polygon[i], projection)});
      if (sources != nullptr) {
        sources->push_back(static_cast<std::uint32_t>(t));
      }
    }
  }
  return result;
}

glm::dvec2 SampleBand::centre(std::size_t at) const {
  const auto row_length = static_cast<std::size_t>(width);
  const std::size_t row = at / row_length;
  return {static_cast<double>(at % row_length) + 0.5, first_row + static_cast<double>(row) + 0.5};
}

void SampleBand::clear(int width_in_samples, int first, int count) {
  width = width_in_samples;
  first_row = first;
  rows = count;
  const std::size_t samples = static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
  inverse_distance.assign(samples, 0.0);
  radiosity.resize(samples);
  source.resize(samples);
}

void draw(const ScreenTriangle& triangle, SampleBand& band, std::uint32_t source) {
  const auto& [a, b, c] = triangle;
  const double area = Edge(a.position, b.position)(c.position);
  if (area == 0.0) {
    return;
  }
  const double inside = area > 0.0 ? 1.0 : -1.0;
  const std::array<Edge, 3> edges = {Edge(b.position, c.position), Edge(c.position, a.position),
                                     Edge(a.position, b.position)};
  const auto [x_low, x_high] = std::minmax({a.position.x, b.position.x, c.position.x});
  const auto [y_low, y_high] = std::minmax({a.position.y, b.position.y, c.position.y});
  const auto [x_begin, x_end] = sample_range(x_low, x_high, band.width);
  const auto [y_begin, y_end] = sample_range(y_low - band.first_row, y_high - band.first_row, band.rows);
  for (int y = y_begin; y < y_end; ++y) {
    for (int x = x_begin; x < x_end; ++x) {
      const glm::dvec2 p(x + 0.5, band.first_row + y + 0.5);
      const glm::dvec3 w = inside * glm::dvec3(edges[0](p), edges[1](p), edges[2](p));
      const double sum = w.x + w.y + w.z;
      if (w.x < 0.0 || w.y < 0.0 || w.z < 0.0 || sum <= 0.0) {
        continue;
      }
      const double inverse =
          (w.x * a.inverse_distance + w.y * b.inverse_distance + w.z * c.inverse_distance) / sum;
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(band.width) + static_cast<std::size_t>(x);
      if (inverse > band.inverse_distance[at]) {
        band.inverse_distance[at] = inverse;
        band.source[at] = source;
        band.radiosity[at] = (w.x * a.radiosity_over_distance + w.y * b.radiosity_over_distance +
                              w.z * c.radiosity_over_distance) /
                             (sum * inverse);
      }
    }
  }
}

}  // namespace fixrad::host

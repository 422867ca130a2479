// SPDX-License-Identifier: MIT
#include "host_sim/report/mesh_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/report/overlay.h"
#include "host_sim/report/tone.h"

namespace fixrad::host {
namespace {

/// Half of a border, on its element's side, samples: neighbours together draw a line of one pixel.
constexpr double kHalfWidth = 0.5 * kPictureSamples;
constexpr double kOpacity = 0.7;
/// Linear luminance of an element below which its border is light instead of dark, and how light.
constexpr double kDarkSurface = 0.02;
constexpr double kLightBorder = 0.12;

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along);
  const double t = square > 0 ? glm::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * along);
}

class Borders : public Overlay {
 public:
  Borders(const BakedMesh& flat, const ElementMesh& elements, std::vector<std::uint32_t> element_of)
      : flat_(flat), elements_(elements), element_of_(std::move(element_of)) {}

  void start_picture(const Projection& projection, double near_distance, double scale) override {
    scale_ = scale;
    triangles_ = visible_triangles(flat_, projection, near_distance, &sources_);
    for (const MeshElement& element : elements_.elements) {
      std::vector<glm::dvec2>& outline = outlines_.emplace_back();
      for (const glm::dvec3& corner : element.polygon) {
        const glm::dvec3 in_camera = projection.to_camera(corner);
        outline.push_back(in_camera.z > near_distance ? projection.to_pixels(in_camera) : kBehind);
      }
    }
  }

  void start_band(const SampleBand& band) override {
    band_.clear(band.width, band.first_row, band.rows);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      draw(triangles_[t], band_, element_of_[sources_[t]]);
    }
  }

  glm::dvec3 over(const glm::dvec3& colour, std::size_t at) const override {
    if (!(band_.inverse_distance[at] > 0.0)) {
      return colour;
    }
    const glm::dvec2 sample = band_.centre(at);
    const std::vector<glm::dvec2>& outline = outlines_[band_.source[at]];
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const glm::dvec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
      if (a != kBehind && b != kBehind && distance_to_segment(sample, a, b) < kHalfWidth) {
        return glm::mix(colour, glm::dvec3(border_of(band_.source[at])), kOpacity);
      }
    }
    return colour;
  }

 private:
  // One for the whole element, or lines would change from dark to light on their way.
  double border_of(std::uint32_t element) const {
    return luminance(tone(flat_.elements[element].radiosity * scale_)) < kDarkSurface ? kLightBorder : 0.0;
  }

  static constexpr double kNowhere = std::numeric_limits<double>::max();
  static inline const glm::dvec2 kBehind{kNowhere, kNowhere};

  const BakedMesh& flat_;
  const ElementMesh& elements_;
  std::vector<std::uint32_t> element_of_;  // [triangles of flat_]
  std::vector<std::vector<glm::dvec2>> outlines_;
  std::vector<ScreenTriangle> triangles_;
  std::vector<std::uint32_t> sources_;
  SampleBand band_;
  double scale_ = 1;
};

}  // namespace

BakedMesh flat_mesh(const BakedMesh& mesh, const ElementMesh& elements) {
  BakedMesh flat;
  flat.name = mesh.name;
  flat.elements = mesh.elements;
  for (std::size_t e = 0; e < elements.elements.size(); ++e) {
    const MeshElement& element = elements.elements[e];
    const auto first = static_cast<std::uint32_t>(flat.positions.size());
    const auto corners = static_cast<std::uint32_t>(element.polygon.size());
    flat.positions.insert(flat.positions.end(), element.polygon.begin(), element.polygon.end());
    flat.normals.insert(flat.normals.end(), corners, element.normal);
    flat.radiosity.insert(flat.radiosity.end(), corners, mesh.elements[e].radiosity);
    for (std::uint32_t k = 2; k < corners; ++k) {
      flat.triangles.push_back({first, first + k - 1, first + k});
    }
  }
  return flat;
}

Image render_mesh_picture(const BakedMesh& mesh, const ElementMesh& elements, const Display& display,
                          const PictureOptions& options) {
  const BakedMesh flat = flat_mesh(mesh, elements);
  std::vector<std::uint32_t> element_of;
  for (std::uint32_t e = 0; e < elements.elements.size(); ++e) {
    element_of.insert(element_of.end(), std::max<std::size_t>(elements.elements[e].polygon.size(), 2) - 2, e);
  }
  Borders borders(flat, elements, std::move(element_of));
  return render_overlaid(mesh, display, options, &borders);
}

}  // namespace fixrad::host

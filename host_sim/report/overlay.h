// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/report/picture.h"
#include "host_sim/report/rasterizer.h"

namespace fixrad::host {

/// Samples along each side of a pixel.
inline constexpr int kPictureSamples = 4;

/// Something that is drawn over the samples of a picture.
class Overlay {
 public:
  Overlay() = default;
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;
  virtual ~Overlay() = default;

  /// `scale`: from radiosity to exposed values.
  virtual void start_picture(const Projection& projection, double near_distance, double scale) = 0;
  /// The band whose samples come next.
  virtual void start_band(const SampleBand& band) = 0;
  /// `colour` (linear display) of the band's sample `at` with the overlay over it.
  virtual glm::dvec3 over(const glm::dvec3& colour, std::size_t at) const = 0;
};

/// render_picture() with an overlay, or none.
Image render_overlaid(const BakedMesh& mesh, const Display& display, const PictureOptions& options,
                      Overlay* overlay);

}  // namespace fixrad::host

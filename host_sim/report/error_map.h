// SPDX-License-Identifier: MIT
// Where a solution is too bright or too dark, as a picture in false colours.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/report/picture.h"

namespace fixrad::host {

/// Signed relative errors over a picture: 0.05 is 5 % too bright; NaN where nothing is seen.
struct ErrorMap {
  int width = 0, height = 0;   ///< pixels
  std::vector<double> errors;  ///< kErrorSamples x kErrorSamples a pixel: rows of samples from the top
};
inline constexpr int kErrorSamples = 2;

/// A convex polygon with one error for all of it.
struct ErrorPolygon {
  std::vector<glm::dvec3> corners;  ///< counter-clockwise seen from the lit side, scene unit
  double error = 0;
};

/// (baked - reference) / max(reference, floor) at each sample, of the sum of the channels of the two meshes'
/// interpolated radiosity, seen by one camera. floor > 0, W/m^2: what is nearly black does not look worse
/// than it is. `picture` needs a camera.
ErrorMap point_errors(const BakedMesh& baked, const BakedMesh& reference, double floor, bool z_up,
                      const PictureOptions& picture);

/// The errors of polygons, seen by the same camera.
ErrorMap polygon_errors(const std::vector<ErrorPolygon>& polygons, bool z_up, const PictureOptions& picture);

/// The magnitude that `part` (0 .. 1) of the samples do not exceed; 0 if nothing is seen.
double error_quantile(const ErrorMap& map, double part);

/// The smallest of 1, 2 and 5 times a power of ten that is at least `value`, and at least 0.001.
double nice_limit(double value);

/// Colours at equal steps from -limit over 0 to +limit: blue is too dark, red too bright. Source:
/// ColorBrewer's diverging scheme RdBu with nine classes (Harrower & Brewer 2003), which the colour-blind can
/// read.
inline constexpr std::array<std::array<std::uint8_t, 3>, 9> kErrorColours = {{{33, 102, 172},
                                                                              {67, 147, 195},
                                                                              {146, 197, 222},
                                                                              {209, 229, 240},
                                                                              {247, 247, 247},
                                                                              {253, 219, 199},
                                                                              {244, 165, 130},
                                                                              {214, 96, 77},
                                                                              {178, 24, 43}}};

/// The map in kErrorColours, beyond +-limit in the outermost ones; dark grey where nothing is seen.
Image false_colours(const ErrorMap& map, double limit);

}  // namespace fixrad::host
